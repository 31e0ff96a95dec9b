#include "nodes/lod/drawing/TeLodGl.h"

#include "nodes/context/TeGlLoader.h"

bool TeLodGl::load(std::uint32_t context) {
  if (!TeMeshGl::load(context))
    return false;
  TeGlLoader gl(context);
  gl.need("glGetIntegerv", getIntegerv);
  gl.need("glGetFloatv", getFloatv);
  gl.need("glMatrixMode", matrixMode);
  gl.need("glLoadMatrixf", loadMatrixf);
  gl.need("glLoadMatrixd", loadMatrixd);
  gl.need("glPolygonMode", polygonMode);
  gl.need("glBufferSubData", bufferSubData);
  gl.need("glDrawArrays", drawArrays);
  gl.need("glBegin", begin);
  gl.need("glEnd", end);
  gl.need("glVertex3fv", vertex3fv);
  gl.need("glNormal3sv", normal3sv);
  gl.need("glColor4ubv", color4ubv);
  gl.need("glGenLists", genLists);
  gl.need("glNewList", newList);
  gl.need("glEndList", endList);
  gl.need("glCallList", callList);
  gl.need("glDeleteLists", deleteLists);
  return gl.isComplete("terrain is not drawn");
}
