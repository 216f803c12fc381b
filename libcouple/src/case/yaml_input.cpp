#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "input.hpp"
#include "slope/couple/text_file.hpp"
#include "suggestion.hpp"

namespace slope::couple {

namespace {

constexpr int deepest_nesting = 30;
constexpr std::size_t most_nodes = 500'000;  // anchors can make much of little
constexpr std::size_t most_keys = 10'000;    // of one map
constexpr std::size_t longest_key = 100;     // bytes

/// The file holds what cannot be what it is taken for.
struct WrongKind {
  int line;
  std::string message;
};

/// Turns yaml-cpp's nodes into documents and notes what a case file cannot hold.
class Converter {
 public:
  Converter(const std::string& file, std::vector<Problem>& problems, const YamlKind& kind)
      : file_(file), problems_(problems), kind_(kind) {}

  Document convert(const YAML::Node& node, const std::string& path, int line, int depth = 0) {
    Document document;
    document.file = file_;
    document.line = node.Mark().is_null() ? line : node.Mark().line + 1;
    if (depth > deepest_nesting)
      throw WrongKind{document.line, fmt::format("nested too deeply for a {} file", kind_.content)};
    if (++nodes_ > most_nodes) {
      throw WrongKind{document.line,
                      fmt::format("more than {} values and lists up to here, anchors counted wherever they "
                                  "are used; put long lists into a table",
                                  most_nodes)};
    }
    if (node.IsScalar()) {
      document.kind = Document::Kind::value;
      document.value = node.Scalar();
      if (document.value.size() > kind_.longest_text) {
        problems_.push_back({file_, document.line, path,
                             fmt::format("has {} letters, at most {} are possible; is a quotation mark not closed?",
                                         document.value.size(), kind_.longest_text)});
        document.value.resize(kind_.longest_text);
      }
      document.quoted = node.Tag() == "!";
    } else if (node.IsSequence()) {
      document.kind = Document::Kind::list;
      for (const YAML::Node& item : node) {
        const std::string item_path = joined_key(path, std::to_string(document.children.size()));
        document.children.push_back(convert(item, item_path, document.line, depth + 1));
      }
    } else if (node.IsMap()) {
      document.kind = Document::Kind::map;
      if (node.size() > most_keys) {
        throw WrongKind{document.line,
                        fmt::format("a map of {} keys; at most {} are possible", node.size(), most_keys)};
      }
      for (const auto& entry : node) add_entry(document, entry.first, entry.second, path, depth);
    }
    return document;
  }

 private:
  void add_entry(Document& map, const YAML::Node& key, const YAML::Node& value, const std::string& path, int depth) {
    const int line = key.Mark().line + 1;
    if (!key.IsScalar()) {
      problems_.push_back({file_, line, path, "a key must be a single word"});
      return;
    }
    const std::string& name = key.Scalar();
    if (name.size() > longest_key) {
      problems_.push_back(
          {file_, line, path, fmt::format("a key of {} letters, \"{}\"", name.size(), shortened(name))});
      return;
    }
    const std::string entry_path = joined_key(path, name);
    if (const Document* first = map.find(name)) {
      problems_.push_back(
          {file_, line, entry_path, fmt::format("given twice, first in line {}; keep one", first->line)});
      return;
    }
    Document entry = convert(value, entry_path, line, depth + 1);
    entry.line = line;
    entry.key = name;
    map.children.push_back(std::move(entry));
  }

  const std::string& file_;
  std::vector<Problem>& problems_;
  const YamlKind& kind_;
  std::size_t nodes_ = 0;
};

/// Notes what a document begins with.
class Beginning : public YAML::EventHandler {
 public:
  [[nodiscard]] bool is_null() const { return is_null_; }
  [[nodiscard]] int line() const { return line_; }  ///< from 1

  void OnNull(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override { note(mark, true); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override { note(mark); }
  void OnScalar(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                const std::string& /*value*/) override {
    note(mark);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                       YAML::EmitterStyle::value /*style*/) override {
    note(mark);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {
    note(mark);
  }
  void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
  void OnDocumentEnd() override {}
  void OnSequenceEnd() override {}
  void OnMapEnd() override {}

 private:
  void note(const YAML::Mark& mark, bool is_null = false) {
    if (line_ > 0) return;
    line_ = mark.line + 1;
    is_null_ = is_null;
  }

  int line_ = 0;
  bool is_null_ = false;
};

/// The one document of a text; none if it is empty.
/// @throws WrongKind if a second one follows; YAML::Exception
std::optional<YAML::Node> only_document(const std::string& text, const YamlKind& kind) {
  // YAML::LoadAll() goes on until there is no memory left where a comma, which begins nothing, follows a document
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Beginning first, second;
  if (!parser.HandleNextDocument(first) || first.is_null()) return std::nullopt;
  if (parser.HandleNextDocument(second)) {
    throw WrongKind{second.line(),
                    fmt::format("a second {} document begins here; a {} is one document", kind.language, kind.content)};
  }
  return YAML::Load(text);
}

void mark_as_override(Document& document) {
  document.file = override_source;
  document.line = 0;
  for (Document& child : document.children) mark_as_override(child);
}

/// The item of a list that goes by that number or name; nullptr if there is none.
Document* find_item(Document& list, const std::string& word) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  if (error == std::errc() && end == word.data() + word.size()) {
    return index < list.children.size() ? &list.children[index] : nullptr;
  }
  const auto found = std::find_if(list.children.begin(), list.children.end(), [&](const Document& item) {
    const Document* name = item.find("name");
    return name != nullptr && name->value == word;
  });
  return found == list.children.end() ? nullptr : &*found;
}

}  // namespace

Document parse_yaml(const std::string& text, const std::string& file, std::vector<Problem>& problems,
                    const YamlKind& kind) {
  if (text.find('\0') != std::string::npos || !is_utf8(text)) {
    problems.push_back({file, 0, "", fmt::format("not {}: it has bytes that no text has", kind.language)});
    return {};
  }
  try {
    if (const auto document = only_document(text, kind))
      return Converter(file, problems, kind).convert(*document, "", 1);
    problems.push_back({file, 0, "", file == override_source ? "expected a value, got nothing" : "the file is empty"});
    return {};
  } catch (const WrongKind& found) {
    problems.push_back({file, found.line, "", found.message});
    return {};
  } catch (const YAML::Exception& error) {
    problems.push_back({file, error.mark.line + 1, "", fmt::format("not {}: {}", kind.language, error.msg)});
    return {};
  }
}

void apply_override(Document& root, const std::string& assignment, std::vector<Problem>& problems) {
  const auto report = [&](const std::string& key, std::string message) {
    problems.push_back({override_source, 0, key, std::move(message)});
  };
  const std::size_t equals = assignment.find('=');
  const std::vector<std::string> words = words_of(assignment.substr(0, equals));
  const bool nameless = std::any_of(words.begin(), words.end(), [](const std::string& word) { return word.empty(); });
  if (equals == std::string::npos || equals + 1 == assignment.size() || nameless) {
    report("", fmt::format("expected key=value, such as \"stop.time=10 min\", got \"{}\"", assignment));
    return;
  }
  std::vector<Problem> found;
  Document value = parse_yaml(assignment.substr(equals + 1), override_source, found);
  mark_as_override(value);
  const std::string path = assignment.substr(0, equals);
  for (const Problem& problem : found) report(path, problem.message);
  if (!found.empty()) return;

  Document* at = &root;
  std::string reached;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string here = reached;
    reached += (i > 0 ? "." : "") + words[i];
    if (at->kind == Document::Kind::list) {
      at = find_item(*at, words[i]);
      if (at == nullptr) {
        report(reached, fmt::format("{} has no item of that number or name", here));
        return;
      }
    } else if (at->kind == Document::Kind::map) {
      if (at->find(words[i]) == nullptr) {
        Document added = Document::map();
        mark_as_override(added);
        at->set(words[i], std::move(added));
      }
      at = at->find(words[i]);
    } else {
      report(reached, fmt::format("{} is a value and has no keys", here.empty() ? "the file" : here));
      return;
    }
  }
  value.key = at->key;
  *at = std::move(value);
}

}  // namespace slope::couple
