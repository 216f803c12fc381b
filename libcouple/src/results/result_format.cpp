#include "results/result_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace slope::couple {

namespace {

constexpr double largest_count = 9007199254740992.0;  // 2^53: up to here a double has every whole number

Document schema_of_type(const std::string& type) {
  Document schema = Document::map();
  schema.set("type", Document::text(type));
  return schema;
}

/// As JSON has it; none if it is something else, or beyond the range of doubles.
std::optional<double> number_of(const Document& node) {
  if (node.kind != Document::Kind::value || node.quoted) return std::nullopt;
  double value = 0.0;
  const char* end = node.value.data() + node.value.size();
  const auto [stop, error] = std::from_chars(node.value.data(), end, value);
  return error == std::errc() && stop == end && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string in_ascii(std::string text) {
  for (char& letter : text) {
    if (static_cast<unsigned char>(letter) > 0x7e) letter = '?';
  }
  return text;
}

}  // namespace

ResultFormat<double> measured(std::string_view unit) {
  const auto read = [](const Input& input, double& value) {
    value = std::numeric_limits<double>::quiet_NaN();
    if (input.node().kind == Document::Kind::empty) return;
    const auto number = number_of(input.node());
    if (number) {
      value = *number;
    } else {
      input.problem(fmt::format("expected a number or null, got {}", kind_of(input.node())));
    }
  };
  return {read, [](const double& value) { return Document::number(value); },
          [](double& value) { value = std::numeric_limits<double>::quiet_NaN(); }, with_null(schema_of_type("number")),
          std::string(unit)};
}

ResultFormat<Point> place() {
  const ResultFormat<double> one = measured("m");
  const auto read = [one](const Input& input, Point& value) {
    const Document& node = input.node();
    if (node.kind != Document::Kind::list || node.children.size() != value.size()) {
      input.problem(fmt::format("expected [x, y], got {}", kind_of(node)));
      return;
    }
    for (std::size_t i = 0; i < value.size(); ++i) one.read(input.item(i), value[i]);
  };
  const auto write = [one](const Point& value) { return Document::list({one.write(value[0]), one.write(value[1])}); };
  const auto forget = [one](Point& value) {
    for (double& part : value) one.forget(part);
  };
  Document schema = schema_of_type("array");
  schema.set("items", one.schema).set("minItems", Document::number(2)).set("maxItems", Document::number(2));
  return {read, write, forget, std::move(schema), one.unit};
}

ResultFormat<std::size_t> count() {
  const auto read = [](const Input& input, std::size_t& value) {
    const auto number = number_of(input.node());
    if (number && *number >= 0.0 && *number <= largest_count && *number == std::floor(*number)) {
      value = static_cast<std::size_t>(*number);
    } else {
      input.problem(fmt::format("expected a whole number, got {}", kind_of(input.node())));
    }
  };
  Document schema = schema_of_type("integer");
  schema.set("minimum", Document::number(0));
  return {read, [](const std::size_t& value) { return Document::number(static_cast<double>(value)); },
          [](std::size_t& value) { value = 0; }, std::move(schema)};
}

ResultFormat<bool> yes_or_no() {
  const auto read = [](const Input& input, bool& value) {
    const Document& node = input.node();
    const bool known = node.kind == Document::Kind::value && !node.quoted;
    if (!known || (node.value != "true" && node.value != "false"))
      input.problem(fmt::format("expected true or false, got {}", kind_of(node)));
    value = node.value == "true";
  };
  return {read, [](const bool& value) { return Document::flag(value); }, [](bool& value) { value = false; },
          schema_of_type("boolean")};
}

ResultFormat<std::string> words() {
  const auto read = [](const Input& input, std::string& value) {
    if (const auto text = expect_value(input, "a text")) value = *text;
  };
  // names of files, and messages with them, may have bytes that no text has
  const auto write = [](const std::string& value) { return Document::text(is_utf8(value) ? value : in_ascii(value)); };
  return {read, write, [](std::string& value) { value.clear(); }, schema_of_type("string")};
}

ResultFormat<std::map<std::string, double>> by_name(std::string_view unit) {
  using Amounts = std::map<std::string, double>;
  const ResultFormat<double> one = measured(unit);
  const auto read = [one](const Input& input, Amounts& values) {
    values.clear();
    if (!expect_map(input, 0)) return;
    for (const Document& entry : input.node().children) one.read(input.at(entry.key), values[entry.key]);
  };
  const auto write = [one](const Amounts& values) {
    Document map = Document::map();
    for (const auto& [name, value] : values) map.set(name, one.write(value));
    return map;
  };
  Document schema = schema_of_type("object");
  schema.set("additionalProperties", one.schema);
  return {read, write, [](Amounts& values) { values.clear(); }, std::move(schema), one.unit};
}

std::string unit_suffix(std::string_view unit) {
  if (unit.empty() || unit == "-") return "";
  std::string suffix = "_";
  for (const char letter : unit) suffix += letter == '/' ? std::string("_per_") : std::string(1, letter);
  return suffix;
}

Document with_null(Document schema) {
  Document type = *schema.find("type");
  if (type.kind == Document::Kind::list) return schema;
  schema.set("type", Document::list({std::move(type), Document::text("null")}));
  return schema;
}

Document described_key(Document schema, const std::string& meaning, const std::string& unit) {
  return described(std::move(schema), unit.empty() ? meaning : fmt::format("{} ({})", meaning, unit));
}

Document words_schema(const std::vector<std::pair<std::string, std::string>>& words) {
  std::vector<Document> texts;
  std::string meanings;
  for (const auto& [text, meaning] : words) {
    texts.push_back(Document::text(text));
    meanings += fmt::format("{}{}: {}", meanings.empty() ? "" : "; ", text, meaning);
  }
  Document schema = choice_schema(texts);
  schema.set("description", Document::text(meanings));
  return schema;
}

void report_unknown_keys(const Input& map, const std::vector<FieldHead>& keys) {
  std::vector<std::string> known;
  for (const FieldHead& key : keys) known.push_back(key.name);
  for (const Document& entry : map.node().children) {
    if (std::find(known.begin(), known.end(), entry.key) == known.end())
      map.at(entry.key).warning("unknown key" + suggestion(entry.key, known));
  }
}

}  // namespace slope::couple
