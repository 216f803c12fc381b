#include "particle_layout.hpp"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <vector>

#include "quiet_vtk.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/text_file.hpp"
#include "xml_tags.hpp"

namespace slope::tools {

namespace {

constexpr std::size_t most_bytes = std::size_t{4} << 30U;
constexpr std::uint64_t most_block_bytes = 100'000'000;
constexpr std::uint64_t most_components = 9;
constexpr std::uint64_t most_field_values = 1000;

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Bytes of a value of a type; 0: no such type is written.
std::uint64_t bytes_of(std::string_view type) {
  if (type == "Float64" || type == "Int64") return 8;
  if (type == "Float32" || type == "Int32") return 4;
  return 0;
}

/// Goes through the tags of a file's head and the blocks that they point to.
class Layout {
 public:
  explicit Layout(std::string_view content) : content_(content) {
    constexpr std::string_view mark = "<AppendedData encoding=\"raw\">";
    const auto appended = content.find(mark);
    head_ = content.substr(0, appended);
    const auto underscore = appended == std::string_view::npos ? appended : content.find('_', appended + mark.size());
    if (underscore != std::string_view::npos) data_ = content.substr(underscore + 1);
  }

  [[nodiscard]] bool is_particle_file() const {
    const auto tags = xml_tags(head_);
    for (const XmlTag& tag : tags) {
      if (tag.name == "VTKFile")
        return tag.value("type") == "PolyData" && tag.value("compressor") == "vtkZLibDataCompressor" &&
               content_.find("<AppendedData encoding=\"raw\">") != std::string_view::npos;
    }
    return false;
  }

  [[nodiscard]] bool is_whole() {
    int pieces = 0;
    for (const XmlTag& tag : xml_tags(head_)) {
      if (tag.name == "VTKFile") {
        if (tag.value("byte_order") != "LittleEndian") return false;
        wide_ = tag.value("header_type") == "UInt64";
      } else if (tag.name == "Piece") {
        const auto points = whole_number(tag.value("NumberOfPoints"));
        const auto cells = whole_number(tag.value("NumberOfVerts"));
        if (++pieces > 1 || !points || !cells || *cells > *points) return false;
        points_ = *points;
        cells_ = *cells;
      } else if (tag.name == "DataArray" || tag.name == "Array") {
        if (!has_its_data(tag)) return false;
      } else if (!tag.name.starts_with('/') && tag.name != "InformationKey") {
        section_ = tag.name;
      }
    }
    return pieces == 1 && content_.find("</VTKFile>") != std::string_view::npos;
  }

 private:
  /// Values of an array; none if nobody can tell.
  [[nodiscard]] std::optional<std::uint64_t> values_of(const XmlTag& tag) const {
    if (section_ == "FieldData") return whole_number(tag.value("NumberOfTuples"));
    if (section_ == "PointData" || section_ == "Points") return points_;
    if (section_ == "Verts") return cells_;
    return std::uint64_t{0};
  }

  [[nodiscard]] bool has_its_data(const XmlTag& tag) const {
    const auto offset = whole_number(tag.value("offset"));
    if (tag.value("format") != "appended" || !offset || *offset > data_.size()) return false;
    const auto stored = stored_bytes(data_.substr(*offset));
    if (!stored) return false;
    if (tag.name == "Array") return tag.value("type") == "String" && *stored <= most_field_values;
    const std::string_view written = tag.value("NumberOfComponents");
    const auto components = written.empty() ? std::uint64_t{1} : whole_number(written);
    const auto values = values_of(tag);
    const std::uint64_t bytes = bytes_of(tag.value("type"));
    if (bytes == 0 || !components || *components == 0 || *components > most_components || !values) return false;
    if (section_ == "FieldData" && *values > most_field_values) return false;
    return *values <= most_bytes && *stored == *values * *components * bytes;
  }

  /// What the blocks at the beginning of some data hold when they are unpacked; none if they are not all there.
  [[nodiscard]] std::optional<std::uint64_t> stored_bytes(std::string_view data) const {
    const std::uint64_t width = wide_ ? 8 : 4;
    const auto number = [&](std::uint64_t index) {
      std::uint64_t value = 0;
      if (wide_) {
        std::memcpy(&value, data.data() + index * width, 8);
      } else {
        std::uint32_t narrow = 0;
        std::memcpy(&narrow, data.data() + index * width, 4);
        value = narrow;
      }
      return value;
    };
    if (data.size() < width) return std::nullopt;
    const std::uint64_t blocks = number(0);
    if (blocks == 0) return std::uint64_t{0};
    if (blocks > data.size() / width || data.size() / width < blocks + 3) return std::nullopt;
    const std::uint64_t block = number(1), last = number(2);
    if (block == 0 || block > most_block_bytes || last > block) return std::nullopt;
    std::uint64_t at = (blocks + 3) * width;
    std::vector<unsigned char> unpacked(block);
    for (std::uint64_t i = 0; i < blocks; ++i) {
      const std::uint64_t packed = number(3 + i);
      const std::uint64_t size = i + 1 == blocks && last > 0 ? last : block;
      if (packed > data.size() - at) return std::nullopt;
      const auto* begin = reinterpret_cast<const unsigned char*>(data.data() + at);
      if (compressor_->Uncompress(begin, packed, unpacked.data(), size) != size) return std::nullopt;
      at += packed;
    }
    return last > 0 ? (blocks - 1) * block + last : blocks * block;
  }

  vtkNew<vtkZLibDataCompressor> compressor_;
  std::string_view content_, head_, data_;
  std::string section_;
  std::uint64_t points_ = 0, cells_ = 0;
  bool wide_ = false;
};

}  // namespace

void check_particle_layout(const std::filesystem::path& file) {
  const std::string content = couple::read_bytes(file, most_bytes);
  const QuietVtk quiet;
  Layout layout(content);
  if (!layout.is_particle_file())
    throw couple::FileError(fmt::format("{}: is not a particle file of slope-sim", file.string()));
  if (!layout.is_whole()) throw couple::FileError(fmt::format("{}: is cut short or damaged", file.string()));
}

}  // namespace slope::tools
