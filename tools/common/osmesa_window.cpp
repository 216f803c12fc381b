#include <vtk_glew.h>
// GLEW comes before everything that includes OpenGL.
#include <vtkGenericOpenGLRenderWindow.h>

#include "osmesa_context.hpp"
#include "render_window.hpp"

namespace slope::tools {
namespace {

/// VTK's window for foreign contexts, on an OSMesa context of its own.
class OsmesaWindow : public vtkGenericOpenGLRenderWindow {
 public:
  using Superclass = vtkGenericOpenGLRenderWindow;
  static OsmesaWindow* New() {
    auto* window = new OsmesaWindow;
    window->InitializeObjectBase();
    return window;
  }
  OsmesaWindow(const OsmesaWindow&) = delete;
  OsmesaWindow& operator=(const OsmesaWindow&) = delete;

  void MakeCurrent() override { context_.make_current(); }
  bool IsCurrent() override { return context_.is_current(); }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 0; }
  void Initialize() override {
    MakeCurrent();
    OpenGLInit();
  }
  void Render() override {
    MakeCurrent();
    Superclass::Render();
  }
  void OpenGLInitContext() override {
    if (Initialized) {
      return;
    }
    MakeCurrent();
    glewExperimental = GL_TRUE;
    const GLenum status = glewInit();
    const bool usable =
        status == GLEW_OK || status == GLEW_ERROR_NO_GLX_DISPLAY || status == GLEW_ERROR_GLX_VERSION_11_ONLY;
    if (!usable || !GLEW_VERSION_3_2) {
      throw RenderError("pictures cannot be drawn: OpenGL 3.2 is not available from OSMesa");
    }
    while (glGetError() != GL_NO_ERROR) {  // left by GLEW's queries
    }
    Initialized = true;
  }

 protected:
  OsmesaWindow() {
    FrameBlitMode = NoBlit;
    SetShowWindow(false);
    SetUseOffScreenBuffers(true);
    SetForceMaximumHardwareLineWidth(1.0F);  // llvmpipe's wide lines have gaps; VTK's own do not
    SetMapped(1);
  }
  ~OsmesaWindow() override { Finalize(); }

 private:
  OsmesaContext context_;
};

}  // namespace

vtkSmartPointer<vtkRenderWindow> make_offscreen_window(int width, int height) {
  auto window = vtkSmartPointer<OsmesaWindow>::New();
  window->SetSize(width, height);
  window->SetMultiSamples(4);
  window->Initialize();
  return window;
}

}  // namespace slope::tools
