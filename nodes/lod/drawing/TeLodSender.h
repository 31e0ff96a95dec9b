#pragma once

#include "nodes/lod/drawing/TeLodArrays.h"
#include "nodes/lod/drawing/TeLodGl.h"
#include "nodes/lod/drawing/TeLodSubmission.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// Sends triangles to OpenGL in one of document 003's ways, with the state of the fixed-function pipeline, or
/// the program, that is set. All calls but live() with the context current; those that draw or keep between
/// begin() and end().
class TeLodSender {
public:
  /// A part that stays: in OpenGL, or in main memory if its way sends it each time.
  struct Kept {
    TeLodArrays arrays;
    GLuint vertices = 0; ///< buffers
    GLuint indices = 0;
    GLuint list = 0;
    GLsizei count = 0; ///< of indices
    GLenum indexType = GL_UNSIGNED_SHORT;
    std::int64_t triangles = 0;
    std::size_t bytes = 0; ///< of memory, wherever it is
  };

  explicit TeLodSender(const TeLodGl& gl) : m_gl(gl) {}
  TeLodSender(const TeLodSender&) = delete;
  TeLodSender& operator=(const TeLodSender&) = delete;

  /// Without colours the material's are used. Leaves the client state of whoever drew before alone until
  /// end(), which puts it back.
  void begin(TeLodSubmission way, bool withColours);
  void end();

  /// False: parts of this way cannot be kept, or not now, since a display list of someone else is open.
  bool keepsParts() const { return m_keeps; }
  Kept keep(TeLodArrays&& arrays);
  void draw(const Kept& part);
  /// Draws the first `count` of some parts that do not stay.
  void drawOnce(const std::vector<TeLodArrays>& parts, std::size_t count);
  void free(const Kept& part);
  /// Buffers that drawOnce() has made.
  void freeStream();

  /// So far: bytes that OpenGL was given, draw calls.
  std::int64_t bytesSent() const { return m_bytesSent; }
  std::int64_t drawCalls() const { return m_drawCalls; }
  /// Buffers and lists in all contexts together; for tests of leaks.
  static std::int64_t live();

private:
  GLuint makeBuffer(const void* data, std::size_t bytes, GLenum usage);
  void deleteBuffer(GLuint buffer);
  void pointAt(const void* vertices) const;
  void sendFromMemory(const TeLodArrays& arrays);
  void sendCalls(const TeLodArrays& arrays);
  void drawFromBuffers(const std::vector<TeLodArrays>& parts, std::size_t count);

  const TeLodGl& m_gl;
  TeLodSubmission m_way = TeLodSubmission::VboStatic;
  bool m_withColours = false;
  bool m_keeps = true;
  bool m_usesBuffers = true;
  GLuint m_streamVertices = 0;
  GLuint m_streamIndices = 0;
  std::int64_t m_bytesSent = 0;
  std::int64_t m_drawCalls = 0;
};
