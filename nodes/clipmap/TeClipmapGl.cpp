#include "nodes/clipmap/TeClipmapGl.h"

#include <Inventor/C/glue/gl.h>

#include <string>
#include <type_traits>

TeStatus TeClipmapGl::load(std::uint32_t context) {
  const cc_glglue* glue = cc_glglue_instance(int(context));
  const char* missing = nullptr;
  const auto need = [&](const char* name, auto*& function) {
    function =
        reinterpret_cast<std::remove_reference_t<decltype(function)>>(cc_glglue_getprocaddress(glue, name));
    if (!function)
      missing = name;
  };
  need("glGenTextures", genTextures);
  need("glDeleteTextures", deleteTextures);
  need("glBindTexture", bindTexture);
  need("glBindBuffer", bindBuffer);
  need("glTexImage3D", texImage3D);
  need("glTexSubImage3D", texSubImage3D);
  need("glTexParameteri", texParameteri);
  need("glPixelStorei", pixelStorei);
  need("glGetIntegerv", getIntegerv);
  need("glGetError", getError);
  if (missing)
    return TeError{std::string("clipmaps: OpenGL lacks ") + missing};
  if (!cc_glglue_glversion_matches_at_least(glue, 3, 0, 0))
    return TeError{"clipmaps need OpenGL 3.0 or later"};
  return {};
}
