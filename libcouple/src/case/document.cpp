#include "slope/couple/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace slope::couple {

Document Document::text(std::string value) {
  Document document;
  document.kind = Kind::value;
  document.value = std::move(value);
  document.quoted = true;
  return document;
}

Document Document::number(double value) {
  Document document;
  if (std::isfinite(value)) {
    document.kind = Kind::value;
    document.value = fmt::format("{}", value);
    // YAML 1.1 takes 1e-06 for a text.
    const auto exponent = document.value.find('e');
    if (exponent != std::string::npos && document.value.find('.') == std::string::npos)
      document.value.insert(exponent, ".0");
  }
  return document;
}

Document Document::flag(bool value) {
  Document document;
  document.kind = Kind::value;
  document.value = value ? "true" : "false";
  return document;
}

Document Document::list(std::vector<Document> items) {
  Document document;
  document.kind = Kind::list;
  document.children = std::move(items);
  return document;
}

Document Document::map() {
  Document document;
  document.kind = Kind::map;
  return document;
}

Document& Document::set(std::string_view name, Document entry) {
  entry.key = name;
  if (Document* existing = find(name)) {
    *existing = std::move(entry);
  } else {
    children.push_back(std::move(entry));
  }
  return *this;
}

const Document* Document::find(std::string_view name) const {
  if (kind != Kind::map) return nullptr;
  const auto found = std::find_if(children.begin(), children.end(), [&](const Document& c) { return c.key == name; });
  return found == children.end() ? nullptr : &*found;
}

Document* Document::find(std::string_view name) {
  return const_cast<Document*>(std::as_const(*this).find(name));
}

namespace {

/// A text between double quotes, with the escapes that JSON and YAML share.
std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\t':
        out += "\\t";
        break;
      case '\r':
        out += "\\r";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
          out += c;
        }
    }
  }
  return out + '"';
}

void write_json(const Document& document, const std::string& indent, std::string& out) {
  switch (document.kind) {
    case Document::Kind::empty:
      out += "null";
      return;
    case Document::Kind::value:
      out += document.quoted ? in_quotes(document.value) : document.value;
      return;
    case Document::Kind::list:
    case Document::Kind::map:
      break;
  }
  const bool map = document.kind == Document::Kind::map;
  if (document.children.empty()) {
    out += map ? "{}" : "[]";
    return;
  }
  const std::string inner = indent + "  ";
  out += map ? '{' : '[';
  for (const Document& child : document.children) {
    out += &child == &document.children.front() ? "\n" : ",\n";
    out += inner;
    if (map) out += in_quotes(child.key) + ": ";
    write_json(child, inner, out);
  }
  out += '\n' + indent + (map ? '}' : ']');
}

/// Whether a text can stand in YAML without quotes and still be read as a text.
bool is_plain(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (text.empty() || text.back() == ' ') return false;
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string_view word : {"true", "false", "null", "yes", "no", "on", "off"}) {
    if (lower == word) return false;
  }
  const bool number = digit(text.front()) || (text.front() == '-' && text.size() > 1 && digit(text[1]));
  const bool quantity = number && text.find(' ') != std::string_view::npos;
  if (!letter(text.front()) && !quantity) return false;
  return std::all_of(text.begin(), text.end(), [&](char c) {
    return letter(c) || digit(c) || std::string_view(" _-+./%()").find(c) != std::string_view::npos;
  });
}

std::string value_text(const Document& document) {
  if (document.kind == Document::Kind::empty) return "~";
  return document.quoted && !is_plain(document.value) ? in_quotes(document.value) : document.value;
}

bool holds_maps(const Document& document) {
  return document.kind == Document::Kind::map ||
         std::any_of(document.children.begin(), document.children.end(), holds_maps);
}

std::string flow_text(const Document& document) {
  if (document.kind == Document::Kind::map) return "{}";
  if (document.kind != Document::Kind::list) return value_text(document);
  std::string out = "[";
  for (const Document& item : document.children) {
    if (&item != &document.children.front()) out += ", ";
    out += flow_text(item);
  }
  return out + ']';
}

void write_yaml(const Document& document, const std::string& indent, std::string& out) {
  bool first = true;
  for (const Document& child : document.children) {
    if (!first || document.kind == Document::Kind::map) out += first ? "" : indent;
    first = false;
    out += document.kind == Document::Kind::map ? (is_plain(child.key) ? child.key : in_quotes(child.key)) + ':' : "-";
    if (child.children.empty() || !holds_maps(child)) {
      out += ' ' + flow_text(child) + '\n';
      continue;
    }
    const std::string inner = indent + "  ";
    if (document.kind == Document::Kind::map) {
      out += '\n' + inner;
    } else {
      out += ' ';
    }
    write_yaml(child, inner, out);
  }
}

}  // namespace

std::string json_text(const Document& document) {
  std::string out;
  write_json(document, "", out);
  return out + '\n';
}

std::string yaml_text(const Document& document) {
  if (document.children.empty()) return flow_text(document) + '\n';
  std::string out;
  write_yaml(document, "", out);
  return out;
}

}  // namespace slope::couple
