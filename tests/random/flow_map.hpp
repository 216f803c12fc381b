#pragma once

#include <string>
#include <string_view>

namespace slope::random_cases {

/// A map of YAML on one line, key by key. Of calls in a chain, each is done before the arguments of the next are worked
/// out, so that these may draw random numbers.
class FlowMap {
 public:
  FlowMap& add(std::string_view key, std::string_view value) {
    text_ += text_.empty() ? "" : ", ";
    text_.append(key).append(": ").append(value);
    return *this;
  }
  [[nodiscard]] bool empty() const { return text_.empty(); }
  [[nodiscard]] std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

}  // namespace slope::random_cases
