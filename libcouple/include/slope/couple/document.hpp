#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace slope::couple {

/// What a YAML or JSON file holds: a value, a list or a map, in the order of the file.
struct Document {
  enum class Kind { empty, value, list, map };

  Kind kind = Kind::empty;
  std::string key;                 ///< under which it stands in its map; empty in a list
  std::string value;               ///< of a value: its text
  bool quoted = false;             ///< the value is a text, even if it reads like a number
  std::string file;                ///< it was read from; "--set": it is an override
  int line = 0;                    ///< of that file, 1-based; 0: none
  std::vector<Document> children;  ///< of a list or a map

  [[nodiscard]] static Document text(std::string value);
  [[nodiscard]] static Document number(double value);  ///< shortest text that reads back the same; not finite: empty
  [[nodiscard]] static Document flag(bool value);
  [[nodiscard]] static Document list(std::vector<Document> items = {});
  [[nodiscard]] static Document map();

  /// Adds or replaces an entry of a map.
  Document& set(std::string_view name, Document entry);
  /// The entry of a map; nullptr if there is none.
  [[nodiscard]] const Document* find(std::string_view name) const;
  [[nodiscard]] Document* find(std::string_view name);
};

/// The document as JSON, indented by two spaces and ended by a line feed; empty values become null.
[[nodiscard]] std::string json_text(const Document& document);

/// The document as YAML: maps in block style, lists of values and of lists on one line.
[[nodiscard]] std::string yaml_text(const Document& document);

}  // namespace slope::couple
