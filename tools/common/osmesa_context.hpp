#pragma once

#include <array>
#include <string>

namespace slope::tools {

/// A software OpenGL 3.2 core context from OSMesa with no window behind it; VTK draws into framebuffer objects of its
/// own.
class OsmesaContext {
 public:
  /// @throws RenderError if the context cannot be created, or is not the llvmpipe renderer of libOSMesa.
  OsmesaContext();
  ~OsmesaContext();
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void make_current();
  [[nodiscard]] bool is_current() const;

 private:
  static constexpr int side = 8;  // of the default framebuffer, in which nothing is drawn
  std::array<unsigned char, 4 * side * side> buffer_{};
  void* context_ = nullptr;
};

}  // namespace slope::tools
