#include "nodes/context/TeGlTable.h"

#include "nodes/context/TeGlLoader.h"

TeResult<TeGlTable> TeGlTable::load(const std::function<void*(const char*)>& procAddress) {
  TeGlTable gl;
  TeGlLoader loader(procAddress);
  loader.need("glGetString", gl.getString);
  loader.need("glGetError", gl.getError);
  loader.need("glGetIntegerv", gl.getIntegerv);
  loader.need("glEnable", gl.enable);
  loader.need("glDisable", gl.disable);
  loader.need("glClearColor", gl.clearColor);
  loader.need("glClearDepth", gl.clearDepth);
  loader.need("glClear", gl.clear);
  loader.need("glViewport", gl.viewport);
  loader.need("glFinish", gl.finish);
  loader.need("glPixelStorei", gl.pixelStorei);
  loader.need("glReadPixels", gl.readPixels);
  loader.need("glGenFramebuffers", gl.genFramebuffers);
  loader.need("glDeleteFramebuffers", gl.deleteFramebuffers);
  loader.need("glBindFramebuffer", gl.bindFramebuffer);
  loader.need("glCheckFramebufferStatus", gl.checkFramebufferStatus);
  loader.need("glFramebufferRenderbuffer", gl.framebufferRenderbuffer);
  loader.need("glBlitFramebuffer", gl.blitFramebuffer);
  loader.need("glGenRenderbuffers", gl.genRenderbuffers);
  loader.need("glDeleteRenderbuffers", gl.deleteRenderbuffers);
  loader.need("glBindRenderbuffer", gl.bindRenderbuffer);
  loader.need("glRenderbufferStorageMultisample", gl.renderbufferStorageMultisample);
  if (loader.missing())
    return TeError{std::string("OpenGL lacks ") + loader.missing() + "; version 3.0 is needed"};
  return gl;
}
