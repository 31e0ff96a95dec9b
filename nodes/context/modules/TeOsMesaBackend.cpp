#include "nodes/context/TeContextBackend.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <memory>
#include <vector>

namespace {

class TeOsMesaBackend : public TeContextBackend {
public:
  TeOsMesaBackend(OSMesaContext context, int width, int height)
      : m_context(context), m_width(width), m_height(height), m_pixels(std::size_t(4) * width * height) {}
  ~TeOsMesaBackend() override {
    OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    OSMesaDestroyContext(m_context);
  }

  TeStatus makeCurrent() override {
    if (OSMesaGetCurrentContext() == m_context)
      return {};
    if (!OSMesaMakeCurrent(m_context, m_pixels.data(), GL_UNSIGNED_BYTE, m_width, m_height))
      return TeError{"OSMesaMakeCurrent failed"};
    return {};
  }

  void* procAddress(const char* name) const override {
    return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
  }

private:
  OSMesaContext m_context;
  int m_width;
  int m_height;
  std::vector<unsigned char> m_pixels;
};

// Coin calls gl* functions by the names it was linked with: they must be OSMesa's in the whole program.
bool osMesaProvidesGl() {
  if (!dlsym(RTLD_DEFAULT, "teOsMesaShim"))
    return false;
  Dl_info clear = {};
  Dl_info osMesa = {};
  void* glClear = dlsym(RTLD_DEFAULT, "glClear");
  return glClear && dladdr(glClear, &clear) && dladdr(reinterpret_cast<void*>(&OSMesaMakeCurrent), &osMesa) &&
         clear.dli_fbase == osMesa.dli_fbase;
}

} // namespace

extern "C" void teCreateContext(int width, int height, TeResult<TeContextBackendPtr>* result) {
  if (!osMesaProvidesGl()) {
    *result = TeError{"another OpenGL library was loaded before OSMesa; start the program with a launcher "
                      "(terrane_app) or use egl"};
    return;
  }
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_STENCIL_BITS,
                            8,
                            OSMESA_PROFILE,
                            OSMESA_COMPAT_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
  if (!context) {
    *result = TeError{"OSMesa gives no OpenGL 3.3 compatibility context"};
    return;
  }
  auto backend = std::make_unique<TeOsMesaBackend>(context, width, height);
  if (TeStatus status = backend->makeCurrent(); !status) {
    *result = status.error();
    return;
  }
  *result = TeContextBackendPtr(std::move(backend));
}
