#include <vtkOSOpenGLRenderWindow.h>

#include "render_window.hpp"

namespace slope::tools {

vtkSmartPointer<vtkRenderWindow> make_offscreen_window(int width, int height) {
  auto window = vtkSmartPointer<vtkOSOpenGLRenderWindow>::New();
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetSize(width, height);
  window->SetMultiSamples(4);
  window->Initialize();
  return window;
}

}  // namespace slope::tools
