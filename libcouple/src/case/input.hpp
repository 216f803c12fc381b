#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "slope/couple/document.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple {

/// A place in the case file: a node, its dotted key, and the list that takes the problems found there.
class Input {
 public:
  /// @param warnings  takes what may be meant but is seldom right; null: nobody wants to know
  Input(const Document& root, const std::string& file, std::vector<Problem>& problems,
        std::vector<Problem>* warnings = nullptr);

  [[nodiscard]] const Document& node() const { return *node_; }
  [[nodiscard]] const std::string& key() const { return key_; }
  /// The case file itself; node().file is the one that this place stands in, which may be a base of it.
  [[nodiscard]] const std::string& file() const { return *file_; }

  /// Says what is wrong here.
  void problem(std::string message) const;
  /// Says what may be meant here but is seldom right.
  void warning(std::string message) const;
  /// Says what may be meant by an entry that is missing from this map.
  void warning_with(std::string_view name, std::string message) const;
  /// The same of a line of another file that this place names.
  void warning_in(const std::string& file, int line, std::string message) const;
  /// Says what is wrong in a line of another file that this place names.
  void problem_in(const std::string& file, int line, std::string message) const;
  /// Says what is wrong with an entry that is missing from this map.
  void problem_with(std::string_view name, std::string message) const;
  [[nodiscard]] std::size_t problem_count() const { return problems_->size(); }
  /// Whether nothing was found wrong at that key of the whole file, or below it.
  [[nodiscard]] bool clean(std::string_view key) const;

  [[nodiscard]] bool has(std::string_view name) const { return node_->find(name) != nullptr; }
  /// The entry of that name; this place itself if there is none.
  [[nodiscard]] Input at(std::string_view name) const;
  /// The item of a list; an item with a name goes by it.
  [[nodiscard]] Input item(std::size_t index) const;

 private:
  Input(const Input& parent, const Document& node, std::string key);

  const Document* node_;
  std::string key_;
  const std::string* file_;
  std::vector<Problem>* problems_;
  std::vector<Problem>* warnings_;
};

/// The file that documents from --set name.
inline constexpr const char* override_source = "--set";

/// The dotted key of an entry of a map, or of an item of a list.
[[nodiscard]] std::string joined_key(const std::string& parent, std::string_view name);
/// The words of a dotted key.
[[nodiscard]] std::vector<std::string> words_of(std::string_view key);

/// What a YAML text should be, for messages, and how long the texts in it may be.
struct YamlKind {
  std::string content = "case";
  std::string language = "YAML";
  std::size_t longest_text = 1000;  ///< (bytes)
};

/// Reads YAML text, or JSON, which is YAML too, into a document, every node with its file and line.
/// Text that is not YAML, duplicate keys and more than one document are put into the list of problems.
[[nodiscard]] Document parse_yaml(const std::string& text, const std::string& file, std::vector<Problem>& problems,
                                  const YamlKind& kind = {});

/// Applies "dotted.key=value" to the document. List items go by their number, from 0, or by their name.
void apply_override(Document& root, const std::string& assignment, std::vector<Problem>& problems);

}  // namespace slope::couple
