#include "nodes/clipmap/TeClipmapGl.h"

#include "nodes/context/TeGlLoader.h"

#include <Inventor/C/glue/gl.h>

#include <string>

TeStatus TeClipmapGl::load(std::uint32_t context) {
  TeGlLoader gl(context);
  gl.need("glGenTextures", genTextures);
  gl.need("glDeleteTextures", deleteTextures);
  gl.need("glBindTexture", bindTexture);
  gl.need("glBindBuffer", bindBuffer);
  gl.need("glTexImage3D", texImage3D);
  gl.need("glTexSubImage3D", texSubImage3D);
  gl.need("glTexParameteri", texParameteri);
  gl.need("glPixelStorei", pixelStorei);
  gl.need("glGetIntegerv", getIntegerv);
  gl.need("glGetError", getError);
  if (gl.missing())
    return TeError{std::string("clipmaps: OpenGL lacks ") + gl.missing()};
  if (!cc_glglue_glversion_matches_at_least(cc_glglue_instance(int(context)), 3, 0, 0))
    return TeError{"clipmaps need OpenGL 3.0 or later"};
  return {};
}
