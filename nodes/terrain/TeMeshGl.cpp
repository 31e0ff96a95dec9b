#include "nodes/terrain/TeMeshGl.h"

#include "generators/base/TeLog.h"

#include <Inventor/C/glue/gl.h>

#include <string>
#include <type_traits>

bool TeMeshGl::load(std::uint32_t context) {
  const cc_glglue* glue = cc_glglue_instance(int(context));
  const auto find = [&](const char* name, auto*& function) {
    function =
        reinterpret_cast<std::remove_reference_t<decltype(function)>>(cc_glglue_getprocaddress(glue, name));
    return function != nullptr;
  };
  const char* missing = nullptr;
  const auto need = [&](const char* name, auto*& function) {
    if (!find(name, function))
      missing = name;
  };
  need("glGenBuffers", genBuffers);
  need("glDeleteBuffers", deleteBuffers);
  need("glBindBuffer", bindBuffer);
  need("glBufferData", bufferData);
  need("glPushClientAttrib", pushClientAttrib);
  need("glPopClientAttrib", popClientAttrib);
  need("glEnableClientState", enableClientState);
  need("glDisableClientState", disableClientState);
  need("glVertexPointer", vertexPointer);
  need("glNormalPointer", normalPointer);
  need("glColorPointer", colorPointer);
  need("glDrawElements", drawElements);
  find("glBindVertexArray", bindVertexArray);
  if (missing)
    TeLog::error(std::string("terrain is not drawn: OpenGL lacks ") + missing);
  return !missing;
}
