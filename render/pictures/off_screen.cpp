#include "render/pictures/off_screen.h"

#include <GL/glew.h>  // before anything that brings in OpenGL

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstring>

namespace stickslip::drawing {
namespace {

constexpr int samples = 8;  // per pixel

/// One display for the whole process, never closed: EGL counts its users itself.
EGLDisplay surfaceless_display()
{
    static const EGLDisplay display = []() -> EGLDisplay {
        const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
        if (!extensions || !std::strstr(extensions, "EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
        const auto open =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        const EGLDisplay found =
            open ? open(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr) : EGL_NO_DISPLAY;
        return found != EGL_NO_DISPLAY && eglInitialize(found, nullptr, nullptr) ? found : EGL_NO_DISPLAY;
    }();
    return display;
}

/// Debian's GLEW is built for GLX: it loads every entry point through libglvnd and then reports, as its last act, that
/// no GLX display is there. That one complaint does not matter here (github.com/nigels-com/glew, issue 273).
bool load_entry_points(std::string& reason)
{
    constexpr GLenum no_glx_display = 4;
    static const GLenum status = [] {
        glewExperimental = GL_TRUE;
        return glewInit();
    }();
    if ((status == GLEW_OK || status == no_glx_display) && GLEW_VERSION_3_2) return true;
    reason = "OpenGL 3.2 is not offered off screen";
    return false;
}

/// VTK's window for a context that its user has made current; here the user is the class itself.
class SurfacelessWindow : public vtkGenericOpenGLRenderWindow {
  public:
    static SurfacelessWindow* New();
    vtkTypeMacro(SurfacelessWindow, vtkGenericOpenGLRenderWindow);

    std::string open()
    {
        display_ = surfaceless_display();
        if (display_ == EGL_NO_DISPLAY) return "this machine offers no off-screen OpenGL (EGL without a surface)";
        const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config;
        EGLint found = 0;
        if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display_, wanted, &config, 1, &found) || found == 0)
            return "EGL offers no OpenGL configuration";
        const EGLint version[] = {
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
        if (context_ == EGL_NO_CONTEXT) return "EGL made no OpenGL 3.3 context";
        MakeCurrent();
        std::string reason;
        load_entry_points(reason);
        return reason;
    }

    void MakeCurrent() override { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_); }
    bool IsCurrent() override { return context_ != EGL_NO_CONTEXT && eglGetCurrentContext() == context_; }
    int SupportsOpenGL() override { return 1; }
    vtkTypeBool IsDirect() override { return 1; }
    void Initialize() override
    {
        if (!Initialized) OpenGLInit();
    }
    void OpenGLInitContext() override
    {
        if (Initialized) return;
        ContextCreationTime.Modified();
        GlewInitValid = true;
        Initialized = true;
        GLfloat widths[2] = {1, 1};
        glGetFloatv(GL_SMOOTH_LINE_WIDTH_RANGE, widths);
        MaximumHardwareLineWidth = widths[1];
    }

  protected:
    SurfacelessWindow()
    {
        ShowWindow = false;
        UseOffScreenBuffers = true;
        FrameBlitMode = NoBlit;  // there is no frame buffer of a surface to copy to
        Mapped = 0;
        OwnContext = 1;
        AlphaBitPlanes = 1;
    }
    ~SurfacelessWindow() override
    {
        if (context_ == EGL_NO_CONTEXT) return;
        MakeCurrent();
        Finalize();
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }

  private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};
vtkStandardNewMacro(SurfacelessWindow);

/// Smoothed edges come out mixed with the black of the empty background; PNG wants the colour alone.
void undo_mixing(std::vector<std::uint8_t>& rgba)
{
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        if (const int alpha = rgba[i + 3]; alpha > 0 && alpha < 255)
            for (std::size_t k = 0; k < 3; ++k)
                rgba[i + k] = static_cast<std::uint8_t>(std::min(255, rgba[i + k] * 255 / alpha));
}

}  // namespace

Snapshot photograph(vtkRenderer* scene, int width, int height)
{
    vtkNew<SurfacelessWindow> window;
    Snapshot snapshot;
    snapshot.missing = window->open();
    if (!snapshot.missing.empty()) return snapshot;
    window->SetSize(width, height);
    window->SetMultiSamples(samples);
    scene->SetBackground(0, 0, 0);
    scene->SetBackgroundAlpha(0);
    window->AddRenderer(scene);
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels);
    window->RemoveRenderer(scene);

    snapshot.raster = {width, height, 4, {}};
    const auto row = static_cast<std::size_t>(width) * 4;
    for (int y = height - 1; y >= 0; --y) {  // OpenGL's first row is the lowest
        const std::uint8_t* first = pixels->GetPointer(0) + y * row;
        snapshot.raster.pixels.insert(snapshot.raster.pixels.end(), first, first + row);
    }
    undo_mixing(snapshot.raster.pixels);
    return snapshot;
}

}  // namespace stickslip::drawing
