#include "nodes/context/TeContextBackend.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <string>
#include <type_traits>
#include <vector>

namespace {

class TeEglBackend : public TeContextBackend {
public:
  TeEglBackend(EGLDisplay display, EGLSurface surface, EGLContext context)
      : m_display(display), m_surface(surface), m_context(context) {}
  // The display stays: others may have contexts on it, and terminating it takes theirs away.
  ~TeEglBackend() override {
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(m_display, m_context);
    if (m_surface != EGL_NO_SURFACE)
      eglDestroySurface(m_display, m_surface);
  }

  TeStatus makeCurrent() override {
    if (eglGetCurrentContext() == m_context)
      return {};
    if (!eglMakeCurrent(m_display, m_surface, m_surface, m_context))
      return TeError{"eglMakeCurrent failed"};
    return {};
  }

  void* procAddress(const char* name) const override {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
  }

private:
  EGLDisplay m_display;
  EGLSurface m_surface;
  EGLContext m_context;
};

bool hasWord(const char* words, const char* word) {
  const std::string padded = std::string(" ") + (words ? words : "") + " ";
  return padded.find(std::string(" ") + word + " ") != std::string::npos;
}

template <class Function> Function* procedure(const char* name) {
  return reinterpret_cast<Function*>(eglGetProcAddress(name));
}

/// Displays to try, best first: GPUs, software devices, Mesa's surfaceless platform.
std::vector<EGLDisplay> displays() {
  std::vector<EGLDisplay> found;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto platformDisplay =
      procedure<std::remove_pointer_t<PFNEGLGETPLATFORMDISPLAYEXTPROC>>("eglGetPlatformDisplayEXT");
  if (!platformDisplay)
    return found;

  const auto queryDevices = procedure<std::remove_pointer_t<PFNEGLQUERYDEVICESEXTPROC>>("eglQueryDevicesEXT");
  const auto queryDeviceString =
      procedure<std::remove_pointer_t<PFNEGLQUERYDEVICESTRINGEXTPROC>>("eglQueryDeviceStringEXT");
  if (queryDevices && queryDeviceString && hasWord(client, "EGL_EXT_platform_device")) {
    EGLDeviceEXT devices[64];
    EGLint count = 0;
    if (!queryDevices(64, devices, &count))
      count = 0;
    for (const bool software : {false, true}) {
      for (EGLint i = 0; i < count; i++) {
        if (hasWord(queryDeviceString(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software") == software)
          found.push_back(platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
      }
    }
  }
  if (hasWord(client, "EGL_MESA_platform_surfaceless"))
    found.push_back(platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return found;
}

/// A context on a display, current; the error says how far it came.
TeResult<TeContextBackendPtr> createOn(EGLDisplay display, int width, int height) {
  EGLint major = 0;
  EGLint minor = 0;
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor))
    return TeError{"no EGL display can be initialized"};
  if (!eglBindAPI(EGL_OPENGL_API))
    return TeError{"the EGL display has no desktop OpenGL"};
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_ALPHA_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           24,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &configs) || configs < 1)
    return TeError{"the EGL display has no RGBA8 configuration with depth"};
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            3,
                            EGL_CONTEXT_MINOR_VERSION,
                            3,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                            EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  if (context == EGL_NO_CONTEXT)
    return TeError{"the EGL display gives no OpenGL 3.3 compatibility context"};
  const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  auto backend = std::make_unique<TeEglBackend>(display, surface, context);
  if (TeStatus status = backend->makeCurrent(); !status)
    return status.error();
  return TeContextBackendPtr(std::move(backend));
}

} // namespace

extern "C" void teCreateContext(int width, int height, TeResult<TeContextBackendPtr>* result) {
  *result = TeError{"EGL has neither devices nor the surfaceless platform"};
  for (EGLDisplay display : displays()) {
    *result = createOn(display, width, height);
    if (*result)
      return;
  }
}
