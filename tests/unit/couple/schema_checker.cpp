#include "schema_checker.hpp"

#include <algorithm>
#include <cmath>
#include <regex>

namespace slope::couple::test {

namespace {

bool is_number(const Document& document) {
  static const std::regex number(R"([-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?)");
  return document.kind == Document::Kind::value && !document.quoted && std::regex_match(document.value, number);
}

bool is_boolean(const Document& document) {
  return document.kind == Document::Kind::value && !document.quoted &&
         (document.value == "true" || document.value == "false");
}

std::string type_of(const Document& document) {
  switch (document.kind) {
    case Document::Kind::empty:
      return "null";
    case Document::Kind::list:
      return "array";
    case Document::Kind::map:
      return "object";
    case Document::Kind::value:
      break;
  }
  if (is_boolean(document)) return "boolean";
  return is_number(document) ? "number" : "string";
}

bool equal(const Document& a, const Document& b) {
  if (is_number(a) && is_number(b)) return std::stod(a.value) == std::stod(b.value);
  return type_of(a) == type_of(b) && a.value == b.value;
}

/// Checks one document against one schema, keyword by keyword.
class Checker {
 public:
  Checker(const Document& schema, const Document& document, std::string path)
      : schema_(schema), document_(document), path_(std::move(path)) {}

  std::vector<std::string> violations() {
    for (const Document& keyword : schema_.children) check(keyword);
    return std::move(violations_);
  }

 private:
  void report(const std::string& what) { violations_.push_back(path_ + ": " + what); }
  void descend(const Document& schema, const Document& document, const std::string& name) {
    for (auto& violation : schema_violations(schema, document, path_ + "/" + name))
      violations_.push_back(std::move(violation));
  }
  void expect(bool condition, const Document& keyword) {
    if (!condition) report(keyword.key + " " + keyword.value);
  }

  void check(const Document& keyword) {
    const std::string& name = keyword.key;
    const bool object = document_.kind == Document::Kind::map;
    const bool array = document_.kind == Document::Kind::list;
    const auto size = [&] { return static_cast<double>(document_.children.size()); };
    if (name == "$schema" || name == "title" || name == "description" || name == "default") return;
    if (name == "type") return expect(has_type(keyword), keyword);
    if (name == "const") return expect(equal(document_, keyword), keyword);
    if (name == "enum") {
      return expect(std::any_of(keyword.children.begin(), keyword.children.end(),
                                [&](const auto& v) { return equal(v, document_); }),
                    keyword);
    }
    if (name == "pattern") {
      return expect(type_of(document_) != "string" || std::regex_search(document_.value, std::regex(keyword.value)),
                    keyword);
    }
    if (name == "minimum")
      return expect(!is_number(document_) || std::stod(document_.value) >= std::stod(keyword.value), keyword);
    if (name == "maximum")
      return expect(!is_number(document_) || std::stod(document_.value) <= std::stod(keyword.value), keyword);
    if (name == "exclusiveMinimum")
      return expect(!is_number(document_) || std::stod(document_.value) > std::stod(keyword.value), keyword);
    if (name == "exclusiveMaximum")
      return expect(!is_number(document_) || std::stod(document_.value) < std::stod(keyword.value), keyword);
    if (name == "minItems") return expect(!array || size() >= std::stod(keyword.value), keyword);
    if (name == "maxItems") return expect(!array || size() <= std::stod(keyword.value), keyword);
    if (name == "minProperties") return expect(!object || size() >= std::stod(keyword.value), keyword);
    if (name == "items") return check_items(keyword);
    if (name == "required") return check_required(keyword);
    if (name == "properties") return check_properties(keyword);
    if (name == "additionalProperties") return check_additional(keyword);
    if (name == "propertyNames") return check_names(keyword);
    if (name == "oneOf") return expect(matches(keyword) == 1, keyword);
    if (name == "anyOf") return expect(matches(keyword) >= 1, keyword);
    if (name == "minLength")
      return expect(type_of(document_) != "string" || document_.value.size() >= std::stoul(keyword.value), keyword);
    if (name == "if") return check_condition(keyword);
    if (name == "then" || name == "else") return;
    report("the checker does not know the keyword " + name);
  }

  [[nodiscard]] bool has_type(const Document& type) const {
    if (type.kind == Document::Kind::list) {
      return std::any_of(type.children.begin(), type.children.end(), [this](const auto& t) { return has_type(t); });
    }
    if (type.value != "integer") return type_of(document_) == type.value;
    return is_number(document_) && std::stod(document_.value) == std::floor(std::stod(document_.value));
  }
  void check_items(const Document& items) {
    if (document_.kind != Document::Kind::list) return;
    for (std::size_t i = 0; i < document_.children.size(); ++i)
      descend(items, document_.children[i], std::to_string(i));
  }
  void check_required(const Document& names) {
    if (document_.kind != Document::Kind::map) return;
    for (const Document& name : names.children) {
      if (document_.find(name.value) == nullptr) report("lacks " + name.value);
    }
  }
  void check_properties(const Document& properties) {
    if (document_.kind != Document::Kind::map) return;
    for (const Document& entry : document_.children) {
      if (const Document* schema = properties.find(entry.key)) descend(*schema, entry, entry.key);
    }
  }
  void check_additional(const Document& rule) {
    if (document_.kind != Document::Kind::map) return;
    const Document* properties = schema_.find("properties");
    for (const Document& entry : document_.children) {
      if (properties != nullptr && properties->find(entry.key) != nullptr) continue;
      if (rule.kind == Document::Kind::map) {
        descend(rule, entry, entry.key);
      } else if (rule.value == "false") {
        report("knows no " + entry.key);
      }
    }
  }
  void check_condition(const Document& condition) {
    const bool holds = schema_violations(condition, document_, path_).empty();
    const Document* consequence = schema_.find(holds ? "then" : "else");
    if (consequence == nullptr) return;
    for (auto& violation : schema_violations(*consequence, document_, path_))
      violations_.push_back(std::move(violation));
  }
  void check_names(const Document& rule) {
    if (document_.kind != Document::Kind::map) return;
    for (const Document& entry : document_.children) descend(rule, Document::text(entry.key), entry.key);
  }
  [[nodiscard]] long matches(const Document& branches) const {
    return std::count_if(branches.children.begin(), branches.children.end(),
                         [&](const Document& branch) { return schema_violations(branch, document_, path_).empty(); });
  }

  const Document& schema_;
  const Document& document_;
  std::string path_;
  std::vector<std::string> violations_;
};

}  // namespace

std::vector<std::string> schema_violations(const Document& schema, const Document& document, const std::string& path) {
  return Checker(schema, document, path).violations();
}

}  // namespace slope::couple::test
