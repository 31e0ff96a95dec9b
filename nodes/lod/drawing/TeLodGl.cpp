#include "nodes/lod/drawing/TeLodGl.h"

#include "generators/base/TeLog.h"

#include <Inventor/C/glue/gl.h>

#include <string>
#include <type_traits>

bool TeLodGl::load(std::uint32_t context) {
  if (!TeMeshGl::load(context))
    return false;
  const cc_glglue* glue = cc_glglue_instance(int(context));
  const char* missing = nullptr;
  const auto need = [&](const char* name, auto*& function) {
    function =
        reinterpret_cast<std::remove_reference_t<decltype(function)>>(cc_glglue_getprocaddress(glue, name));
    if (!function)
      missing = name;
  };
  need("glGetIntegerv", getIntegerv);
  need("glGetFloatv", getFloatv);
  need("glMatrixMode", matrixMode);
  need("glLoadMatrixf", loadMatrixf);
  need("glLoadMatrixd", loadMatrixd);
  need("glPolygonMode", polygonMode);
  need("glBufferSubData", bufferSubData);
  need("glDrawArrays", drawArrays);
  need("glBegin", begin);
  need("glEnd", end);
  need("glVertex3fv", vertex3fv);
  need("glNormal3sv", normal3sv);
  need("glColor4ubv", color4ubv);
  need("glGenLists", genLists);
  need("glNewList", newList);
  need("glEndList", endList);
  need("glCallList", callList);
  need("glDeleteLists", deleteLists);
  if (missing)
    TeLog::error(std::string("terrain is not drawn: OpenGL lacks ") + missing);
  return !missing;
}
