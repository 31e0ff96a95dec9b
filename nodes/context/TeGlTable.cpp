#include "nodes/context/TeGlTable.h"

namespace {

using Lookup = std::function<void*(const char*)>;

template <class Function> bool find(const Lookup& lookup, const char* name, Function*& function) {
  function = reinterpret_cast<Function*>(lookup(name));
  return function != nullptr;
}

} // namespace

TeResult<TeGlTable> TeGlTable::load(const Lookup& lookup) {
  TeGlTable gl;
  const char* missing = nullptr;
  const auto need = [&](const char* name, auto*& function) {
    if (!find(lookup, name, function))
      missing = name;
  };
  need("glGetString", gl.getString);
  need("glGetError", gl.getError);
  need("glGetIntegerv", gl.getIntegerv);
  need("glEnable", gl.enable);
  need("glDisable", gl.disable);
  need("glClearColor", gl.clearColor);
  need("glClearDepth", gl.clearDepth);
  need("glClear", gl.clear);
  need("glViewport", gl.viewport);
  need("glFinish", gl.finish);
  need("glPixelStorei", gl.pixelStorei);
  need("glReadPixels", gl.readPixels);
  need("glGenFramebuffers", gl.genFramebuffers);
  need("glDeleteFramebuffers", gl.deleteFramebuffers);
  need("glBindFramebuffer", gl.bindFramebuffer);
  need("glCheckFramebufferStatus", gl.checkFramebufferStatus);
  need("glFramebufferRenderbuffer", gl.framebufferRenderbuffer);
  need("glBlitFramebuffer", gl.blitFramebuffer);
  need("glGenRenderbuffers", gl.genRenderbuffers);
  need("glDeleteRenderbuffers", gl.deleteRenderbuffers);
  need("glBindRenderbuffer", gl.bindRenderbuffer);
  need("glRenderbufferStorageMultisample", gl.renderbufferStorageMultisample);
  if (missing)
    return TeError{std::string("OpenGL lacks ") + missing + "; version 3.0 is needed"};
  return gl;
}
