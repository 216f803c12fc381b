#pragma once

#include <string>
#include <vector>

namespace slope::testing {

/// A line of a corpus in its parts.
inline std::vector<std::string> parted(std::string text, const std::string& by) {
  std::vector<std::string> parts;
  for (std::size_t at = text.find(by); at != std::string::npos; at = text.find(by)) {
    parts.push_back(text.substr(0, at));
    text.erase(0, at + by.size());
  }
  parts.push_back(text);
  return parts;
}

/// With line feeds where it says "\n".
inline std::string with_line_feeds(std::string text) {
  for (std::size_t at = text.find("\\n"); at != std::string::npos; at = text.find("\\n", at)) text.replace(at, 2, "\n");
  return text;
}

}  // namespace slope::testing
