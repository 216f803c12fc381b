#include "xml_tags.hpp"

#include <algorithm>

namespace slope::tools {

namespace {

constexpr std::string_view blanks = " \t\r\n";

void skip_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
}

std::string_view take_until(std::string_view& text, std::string_view ends) {
  const std::string_view taken = text.substr(0, text.find_first_of(ends));
  text.remove_prefix(taken.size());
  return taken;
}

/// name="value" from the beginning of the text; false if there is none.
bool take_attribute(std::string_view& text, XmlTag& tag) {
  skip_blanks(text);
  const std::string_view name = take_until(text, " \t\r\n=/>\"");
  if (name.empty() || !text.starts_with("=\"")) return false;
  text.remove_prefix(2);
  const auto end = text.find('"');
  if (end == std::string_view::npos) return false;
  tag.attributes.emplace_back(name, text.substr(0, end));
  text.remove_prefix(end + 1);
  return true;
}

}  // namespace

std::string_view XmlTag::value(std::string_view attribute) const {
  const auto found = std::ranges::find(attributes, attribute, &std::pair<std::string_view, std::string_view>::first);
  return found == attributes.end() ? std::string_view() : found->second;
}

std::vector<XmlTag> xml_tags(std::string_view text) {
  std::vector<XmlTag> tags;
  for (auto begin = text.find('<'); begin != std::string_view::npos; begin = text.find('<')) {
    text.remove_prefix(begin + 1);
    XmlTag tag;
    tag.name = text.substr(0, text.starts_with('/') ? 1 : 0);
    std::string_view rest = text.substr(tag.name.size());
    tag.name = text.substr(0, tag.name.size() + take_until(rest, " \t\r\n=/><\"").size());
    while (take_attribute(rest, tag)) {
    }
    tags.push_back(std::move(tag));
    text = rest;
  }
  return tags;
}

}  // namespace slope::tools
