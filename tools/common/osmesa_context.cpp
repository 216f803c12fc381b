#include "osmesa_context.hpp"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <string_view>

#include "render_window.hpp"

/// Debian's GLEW asks GLX for its entry points. This definition comes before libGL's and answers from OSMesa; there is
/// no GLX here.
extern "C" __attribute__((visibility("default"))) OSMESAproc glXGetProcAddressARB(const unsigned char* name) {
  const char* text = reinterpret_cast<const char*>(name);
  return std::string_view(text).starts_with("glX") ? nullptr : OSMesaGetProcAddress(text);
}

namespace slope::tools {
namespace {

void require_llvmpipe() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&glGetString), &info) == 0 || info.dli_fname == nullptr ||
      std::string_view(info.dli_fname).find("OSMesa") == std::string_view::npos) {
    throw RenderError("pictures cannot be drawn: OpenGL comes from another library than OSMesa; do not preload libGL");
  }
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (renderer == nullptr || !std::string_view(renderer).starts_with("llvmpipe")) {
    throw RenderError(std::string("pictures cannot be drawn: the OpenGL renderer is ") +
                      (renderer != nullptr ? renderer : "unknown") + ", llvmpipe is needed; unset GALLIUM_DRIVER");
  }
}

}  // namespace

OsmesaContext::OsmesaContext() {
  static constexpr std::array attributes{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_DEPTH_BITS,
                                         24,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         3,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         2,
                                         0};
  context_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
  if (context_ == nullptr) {
    throw RenderError("pictures cannot be drawn: OSMesa offers no OpenGL 3.2 context");
  }
  make_current();
  try {
    require_llvmpipe();
  } catch (...) {
    OSMesaDestroyContext(static_cast<OSMesaContext>(context_));
    throw;
  }
}

OsmesaContext::~OsmesaContext() {
  if (is_current()) {
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  }
  OSMesaDestroyContext(static_cast<OSMesaContext>(context_));
}

void OsmesaContext::make_current() {
  if (OSMesaMakeCurrent(static_cast<OSMesaContext>(context_), buffer_.data(), GL_UNSIGNED_BYTE, side, side) !=
      GL_TRUE) {
    throw RenderError("pictures cannot be drawn: the OSMesa context cannot be made current");
  }
}

bool OsmesaContext::is_current() const {
  return context_ != nullptr && OSMesaGetCurrentContext() == static_cast<OSMesaContext>(context_);
}

}  // namespace slope::tools
