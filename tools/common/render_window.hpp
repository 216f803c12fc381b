#pragma once

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <stdexcept>

namespace slope::tools {

/// Pictures cannot be drawn on this machine.
class RenderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An off-screen window that needs neither a display nor a graphics card. The pixels it draws depend on nothing but
/// the scene.
/// @throws RenderError if no software OpenGL can be had.
[[nodiscard]] vtkSmartPointer<vtkRenderWindow> make_offscreen_window(int width, int height);

}  // namespace slope::tools
