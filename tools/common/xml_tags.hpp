#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace slope::tools {

/// One tag of an XML text with its attributes; a closing tag begins its name with '/'.
struct XmlTag {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes;

  /// What an attribute says; empty if it is not there.
  [[nodiscard]] std::string_view value(std::string_view attribute) const;
};

/// The tags of a text in their order, as far as it is XML. They are views into the text. What stands between them, how
/// they nest, and references such as &lt; are not looked at.
[[nodiscard]] std::vector<XmlTag> xml_tags(std::string_view text);

}  // namespace slope::tools
