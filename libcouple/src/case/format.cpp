#include "format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "slope/couple/text_file.hpp"

namespace slope::couple {

namespace {

Document schema_of_type(const std::string& type) {
  Document schema = Document::map();
  schema.set("type", Document::text(type));
  return schema;
}

Document quantity_schema(Dimension dimension, const Range& range) {
  Document written = schema_of_type("string");
  written.set("pattern", Document::text(quantity_pattern(dimension)));
  if (dimension != Dimension::number) return written;

  Document number = schema_of_type("number");
  if (std::isfinite(range.lower))
    number.set(range.lower_included ? "minimum" : "exclusiveMinimum", Document::number(range.lower));
  if (std::isfinite(range.upper))
    number.set(range.upper_included ? "maximum" : "exclusiveMaximum", Document::number(range.upper));
  Document either = Document::map();
  either.set("anyOf", Document::list({std::move(number), std::move(written)}));
  return either;
}

}  // namespace

Format<double> quantity(Dimension dimension, const Range& range) {
  const auto read = [dimension, range](const Input& input, double& value) {
    const auto written = expect_value(input, fmt::format("one {}", name_of(dimension)));
    if (!written) return;
    const auto parsed = parse_quantity(*written, dimension);
    if (const auto* wrong = std::get_if<std::string>(&parsed)) {
      input.problem(*wrong);
      return;
    }
    value = std::get<double>(parsed);
    if (!range.holds(value))
      input.problem(fmt::format("must be {}, got {}", range.text(dimension), shortened(*written)));
  };
  const auto write = [dimension](const double& value) {
    if (!std::isfinite(value)) return Document{};
    return dimension == Dimension::number ? Document::number(value) : Document::text(quantity_text(value, dimension));
  };
  Document schema = quantity_schema(dimension, range);
  const std::string limits = range.text(dimension);
  std::string units;
  for (const std::string_view unit : units_of(dimension)) units += (units.empty() ? "" : ", ") + std::string(unit);
  std::string meaning = dimension == Dimension::number ? "number" : fmt::format("{} ({})", name_of(dimension), units);
  if (!limits.empty()) meaning += ", " + limits;
  schema.set("description", Document::text(meaning));
  return {read, write, std::move(schema)};
}

Format<bool> flag() {
  const auto read = [](const Input& input, bool& value) {
    const auto word = expect_value(input, "true or false");
    if (!word) return;
    if (*word != "true" && *word != "false")
      input.problem(fmt::format("expected true or false, got \"{}\"", shortened(*word)));
    value = *word == "true";
  };
  return {read, [](const bool& value) { return Document::flag(value); }, schema_of_type("boolean")};
}

Format<std::string> text() {
  const auto read = [](const Input& input, std::string& value) {
    if (const auto words = expect_value(input, "a text")) value = *words;
  };
  return {read, [](const std::string& value) { return value.empty() ? Document{} : Document::text(value); },
          schema_of_type("string")};
}

Format<std::string> path_text() {
  Format<std::string> format = text();
  format.read = [read = format.read](const Input& input, std::string& value) {
    namespace fs = std::filesystem;
    read(input, value);
    const std::string& file = input.node().file;
    if (file == input.file() || file == override_source) return;
    value = (fs::path(file).parent_path() / value).lexically_proximate(fs::path(input.file()).parent_path()).string();
  };
  return format;
}

Format<std::string> name_text() {
  Document schema = schema_of_type("string");
  schema.set("pattern", Document::text(name_pattern()));
  const auto read = [](const Input& input, std::string& value) {
    const auto word = expect_value(input, "a name");
    if (!word) return;
    if (!is_name(*word)) {
      input.problem(fmt::format("a name begins with a letter and has only letters, digits, _ and -; got \"{}\"",
                                shortened(*word)));
    }
    value = *word;
  };
  return {read, [](const std::string& value) { return Document::text(value); }, std::move(schema)};
}

bool is_name(std::string_view text) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto further = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; };
  return !text.empty() && letter(text.front()) && std::all_of(text.begin(), text.end(), further);
}

std::string name_pattern() {
  return "^[A-Za-z][A-Za-z0-9_-]*$";
}

Format<std::array<double, 2>> pair_of(Dimension dimension) {
  const Format<double> one = quantity(dimension);
  const auto read = [one, dimension](const Input& input, std::array<double, 2>& value) {
    const Document& node = input.node();
    if (node.kind != Document::Kind::list || node.children.size() != 2) {
      input.problem(fmt::format(
          "expected [x, y], two {}s, got {}", name_of(dimension),
          node.kind == Document::Kind::list ? fmt::format("a list of {}", node.children.size()) : kind_of(node)));
      return;
    }
    for (std::size_t i = 0; i < 2; ++i) one.read(input.item(i), value[i]);
  };
  const auto write = [one](const std::array<double, 2>& value) {
    return Document::list({one.write(value[0]), one.write(value[1])});
  };
  Document schema = schema_of_type("array");
  schema.set("items", one.schema).set("minItems", Document::number(2)).set("maxItems", Document::number(2));
  return {read, write, std::move(schema)};
}

Document described(Document schema, const std::string& description) {
  const Document* meaning = schema.find("description");
  Document text = Document::text(meaning ? fmt::format("{}: {}", description, meaning->value) : description);
  return schema.set("description", std::move(text));
}

Document object_schema(const std::vector<FieldHead>& fields) {
  Document properties = Document::map();
  Document required = Document::list();
  for (const FieldHead& field : fields) {
    properties.set(field.name, field.schema);
    if (field.required) required.children.push_back(Document::text(field.name));
  }
  Document schema = schema_of_type("object");
  schema.set("properties", std::move(properties));
  if (!required.children.empty()) schema.set("required", std::move(required));
  schema.set("additionalProperties", Document::flag(false));
  return schema;
}

Document overlay_schema(const Document& schema) {
  if (const Document* overlay = schema.find("then")) return overlay_schema(*overlay);
  const bool object = schema.find("properties") != nullptr;
  Document overlay = Document::map();
  for (const Document& keyword : schema.children) {
    if (keyword.key == "required") {
      const bool named = std::any_of(keyword.children.begin(), keyword.children.end(),
                                     [](const Document& name) { return name.value == "name"; });
      if (named) overlay.set("required", Document::list({Document::text("name")}));
    } else if (keyword.key == "properties") {
      Document properties = Document::map();
      for (const Document& property : keyword.children) properties.set(property.key, overlay_schema(property));
      overlay.set("properties", std::move(properties));
    } else if (keyword.key == "additionalProperties") {
      overlay.set(keyword.key, keyword.kind == Document::Kind::map ? overlay_schema(keyword) : keyword);
    } else if (keyword.key == "items") {
      const Document* properties = keyword.find("properties");
      const bool merged = properties != nullptr && properties->find("name") != nullptr;
      overlay.set("items", merged ? overlay_schema(keyword) : keyword);
    } else if (keyword.key == "oneOf") {
      if (object) continue;
      Document branches = Document::list();
      for (const Document& branch : keyword.children) branches.children.push_back(overlay_schema(branch));
      overlay.set("anyOf", std::move(branches));
    } else if (keyword.key != "minProperties" && keyword.key != "default") {
      overlay.set(keyword.key, keyword);
    }
  }
  return overlay;
}

Document choice_schema(const std::vector<Document>& values) {
  Document schema = Document::map();
  return schema.set("enum", Document::list(values));
}

void report_keys(const Input& map, const std::vector<FieldHead>& fields) {
  std::vector<std::string> known;
  for (const FieldHead& field : fields) known.push_back(field.name);
  std::vector<std::string> misspelt;
  for (const Document& entry : map.node().children) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    map.at(entry.key).problem("unknown key" + suggestion(entry.key, known));
    misspelt.push_back(closest_word(entry.key, known).value_or(""));
  }
  for (const FieldHead& field : fields) {
    if (!field.required || map.has(field.name)) continue;
    if (std::find(misspelt.begin(), misspelt.end(), field.name) != misspelt.end()) continue;
    map.problem_with(field.name, fmt::format("missing; write for example \"{}: {}\"", field.name, field.example));
  }
}

bool expect_list(const Input& input, std::size_t least_items) {
  if (input.node().kind != Document::Kind::list) {
    input.problem(fmt::format("expected a list, got {}", kind_of(input.node())));
    return false;
  }
  const std::size_t items = input.node().children.size();
  if (items >= least_items) return true;
  input.problem(fmt::format("needs at least {} item{}, got {}", least_items, least_items == 1 ? "" : "s", items));
  return false;
}

bool expect_map(const Input& input, std::size_t least_entries) {
  if (input.node().kind != Document::Kind::map) {
    input.problem(fmt::format("expected a map of keys, got {}", kind_of(input.node())));
    return false;
  }
  if (input.node().children.size() >= least_entries) return true;
  input.problem(fmt::format("needs at least {} entr{}", least_entries, least_entries == 1 ? "y" : "ies"));
  return false;
}

std::string kind_of(const Document& node) {
  switch (node.kind) {
    case Document::Kind::empty:
      return "nothing";
    case Document::Kind::value:
      return fmt::format("\"{}\"", shortened(node.value));
    case Document::Kind::list:
      return "a list";
    case Document::Kind::map:
      return "a map of keys";
  }
  return "";
}

bool is_text(const Document& value) {
  if (value.quoted || value.value.empty()) return !value.value.empty();
  const bool number = std::holds_alternative<double>(parse_quantity(value.value, Dimension::number));
  return !number && value.value != "true" && value.value != "false";
}

std::optional<std::string> expect_value(const Input& input, const std::string& expected) {
  if (input.node().kind == Document::Kind::value) return input.node().value;
  input.problem(fmt::format("expected {}, got {}", expected, kind_of(input.node())));
  return std::nullopt;
}

}  // namespace slope::couple
