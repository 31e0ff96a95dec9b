// Coin finds GL functions, and whether a context is current, through GLX looked up by name. In a program
// where OSMesa provides OpenGL these answers have to come from OSMesa too: without them buffers, shaders and
// framebuffers go wrong and no error is raised. Loaded before every other OpenGL library.

#include <GL/osmesa.h>

#include <cstring>

#define TE_EXPORT extern "C" __attribute__((visibility("default")))

/// Tells the OSMesa backend that this library is in place.
TE_EXPORT const int teOsMesaShim = 1;

TE_EXPORT void* glXGetCurrentContext() { return reinterpret_cast<void*>(OSMesaGetCurrentContext()); }
TE_EXPORT void* glXGetCurrentDisplay() { return nullptr; }
TE_EXPORT unsigned long glXGetCurrentDrawable() { return 0; }

TE_EXPORT void* glXGetProcAddress(const unsigned char* bytes) {
  const char* name = reinterpret_cast<const char*>(bytes);
  // OSMesa hands out a stub for any name that begins with gl, also for GLX, which it does not have.
  if (std::strncmp(name, "glX", 3) == 0)
    return nullptr;
  return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
}
TE_EXPORT void* glXGetProcAddressARB(const unsigned char* name) { return glXGetProcAddress(name); }
