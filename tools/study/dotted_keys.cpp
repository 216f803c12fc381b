#include "dotted_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "case/format.hpp"
#include "case/input.hpp"
#include "slope/couple/results.hpp"

namespace slope::tools {

namespace {

using couple::Dimension;
using couple::Document;

/// A text that the program has made itself.
Document parsed(const std::string& text) {
  constexpr std::size_t longest_text = 100'000;
  std::vector<couple::Problem> problems;
  Document document = couple::parse_yaml(text, "", problems, {"case", "YAML", longest_text});
  if (!problems.empty()) throw couple::InputError(problems);
  return document;
}

std::optional<std::size_t> index_of(std::string_view word) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(index) : std::nullopt;
}

std::string name_of(const Document& item) {
  const Document* name = item.find("name");
  return name != nullptr ? name->value : "";
}

/// By what the entries of a map or a list go.
std::vector<std::string> names_in(const Document& document) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < document.children.size(); ++i) {
    const Document& child = document.children[i];
    const std::string name = document.kind == Document::Kind::list ? name_of(child) : child.key;
    names.push_back(name.empty() ? std::to_string(i) : name);
  }
  return names;
}

const Document* child_of(const Document& document, const std::string& word) {
  if (document.kind == Document::Kind::list) {
    if (const auto index = index_of(word)) {
      return *index < document.children.size() ? &document.children[*index] : nullptr;
    }
  }
  const std::vector<std::string> names = names_in(document);
  const auto found = std::ranges::find(names, word);
  return found == names.end() ? nullptr : &document.children[static_cast<std::size_t>(found - names.begin())];
}

constexpr std::array dimensions{
    Dimension::number,       Dimension::length,      Dimension::area,           Dimension::time,  Dimension::velocity,
    Dimension::acceleration, Dimension::density,     Dimension::inverse_length, Dimension::angle, Dimension::mass,
    Dimension::force,        Dimension::unit_weight, Dimension::pressure};

std::optional<Dimension> dimension_of(const Document& value) {
  for (const Dimension dimension : dimensions) {
    if (std::holds_alternative<double>(couple::parse_quantity(value.value, dimension))) return dimension;
  }
  return std::nullopt;
}

/// "m" of a meaning that ends with "(m)".
std::optional<std::string> unit_in(const Document& schema) {
  const Document* meaning = schema.find("description");
  if (meaning == nullptr || !meaning->value.ends_with(')')) return std::nullopt;
  const std::size_t from = meaning->value.rfind('(') + 1;
  return meaning->value.substr(from, meaning->value.size() - from - 1);
}

const Document& schema_of_summaries() {
  static const Document schema = parsed(couple::summary_schema());
  return schema;
}

bool is_of_type(const Document& schema, std::string_view wanted) {
  const Document* type = schema.find("type");
  if (type == nullptr) return false;
  return type->value == wanted ||
         std::ranges::any_of(type->children, [&](const Document& one) { return one.value == wanted; });
}

bool is_number(const Document& schema) {
  return is_of_type(schema, "number") || is_of_type(schema, "integer") || is_of_type(schema, "boolean");
}

/// The item of the factors of safety that is meant.
const Document* safety_at(const Document& factors, std::optional<double> at) {
  const Document* chosen = nullptr;
  double best = 0.0;
  for (const Document& item : factors.children) {
    const auto value = number_in(item, at ? "time_s" : "factor", std::nullopt);
    if (!value || (at && *value != *at)) continue;
    if (chosen == nullptr || *value < best) chosen = &item, best = *value;
  }
  return chosen;
}

}  // namespace

CaseNumbers::CaseNumbers(const couple::Case& input) : document_(parsed(couple::resolved_yaml(input))) {}

std::variant<CaseNumber, std::string> CaseNumbers::find(std::string_view key) const {
  const Document* at = &document_;
  CaseNumber found;
  for (const std::string& word : couple::words_of(key)) {
    const Document* next = child_of(*at, word);
    if (next == nullptr) {
      return fmt::format("the case has no number \"{}\"{}{}", couple::shortened(key),
                         found.key.empty() ? "" : ": in " + found.key,
                         at->children.empty() ? " there are no keys" : couple::suggestion(word, names_in(*at)));
    }
    const std::string name = at->kind == Document::Kind::list ? name_of(*next) : "";
    found.key = couple::joined_key(found.key, name.empty() ? word : name);
    at = next;
  }
  const auto dimension = at->kind == Document::Kind::value ? dimension_of(*at) : std::nullopt;
  if (dimension) {
    found.dimension = *dimension;
    return found;
  }
  return fmt::format("is no number of the case, but {}{}", couple::kind_of(*at),
                     at->children.empty() ? "" : couple::suggestion("", names_in(*at)));
}

SummaryNumber summary_number(std::string_view key) {
  const Document* at = &schema_of_summaries();
  SummaryNumber found;
  std::vector<std::string> words = couple::words_of(key);
  for (const std::string& word : words) {
    if (is_of_type(*at, "array")) {
      at = at->find("items");
      // of the factors of safety, the time tells which
      if (words.front() != safety_key || &word != &words[1]) {
        if (!index_of(word)) return {"", fmt::format("expected the number of an item, from 0, got \"{}\"", word)};
        continue;
      }
    }
    const Document* properties = at->find("properties");
    const Document* further = at->find("additionalProperties");
    const Document* next = properties != nullptr ? properties->find(word) : nullptr;
    if (next == nullptr && further != nullptr && further->kind == Document::Kind::map) next = further;
    if (next == nullptr) {
      return {"", fmt::format("a summary has no key \"{}\"{} (slope-sim schema --results tells what they mean)",
                              couple::shortened(key),
                              properties != nullptr ? couple::suggestion(word, names_in(*properties)) : "")};
    }
    at = next;
    found.unit = unit_in(*at).value_or(found.unit);
  }
  if (is_number(*at)) return found;
  const Document* inside = is_of_type(*at, "array") ? at->find("items")->find("properties") : at->find("properties");
  return {"", fmt::format("is no number of a summary{}",
                          inside != nullptr ? couple::suggestion("", names_in(*inside)) : "; choose another key")};
}

std::optional<double> number_in(const Document& summary, std::string_view key, std::optional<double> at) {
  const Document* found = &summary;
  for (const std::string& word : couple::words_of(key)) {
    const bool of_safety = found->kind == Document::Kind::list && found->key == safety_key;
    if (of_safety) found = safety_at(*found, at);
    if (found != nullptr) found = child_of(*found, word);
    if (found == nullptr) return std::nullopt;
  }
  if (found->value == "true" || found->value == "false") return found->value == "true" ? 1.0 : 0.0;
  double value = 0.0;
  const char* end = found->value.data() + found->value.size();
  const auto [stop, error] = std::from_chars(found->value.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

}  // namespace slope::tools
