#include "nodes/terrain/TeMeshGl.h"

#include "nodes/context/TeGlLoader.h"

bool TeMeshGl::load(std::uint32_t context) {
  TeGlLoader gl(context);
  gl.need("glGenBuffers", genBuffers);
  gl.need("glDeleteBuffers", deleteBuffers);
  gl.need("glBindBuffer", bindBuffer);
  gl.need("glBufferData", bufferData);
  gl.need("glPushClientAttrib", pushClientAttrib);
  gl.need("glPopClientAttrib", popClientAttrib);
  gl.need("glEnableClientState", enableClientState);
  gl.need("glDisableClientState", disableClientState);
  gl.need("glVertexPointer", vertexPointer);
  gl.need("glNormalPointer", normalPointer);
  gl.need("glColorPointer", colorPointer);
  gl.need("glDrawElements", drawElements);
  gl.find("glBindVertexArray", bindVertexArray);
  return gl.isComplete("terrain is not drawn");
}
