#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace slope::fuzz {

/// A file in a scratch folder of this process with such a content; the folder goes when the process ends as it should.
[[nodiscard]] std::filesystem::path file_with(std::string_view name, std::string_view content);

[[nodiscard]] inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace slope::fuzz
