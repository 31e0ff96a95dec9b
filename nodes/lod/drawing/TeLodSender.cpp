#include "nodes/lod/drawing/TeLodSender.h"

#include <cstddef>
#include <utility>

namespace {

std::int64_t liveCount = 0; ///< OpenGL is used by one thread only

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

const void* after(const void* start, std::size_t bytes) { return static_cast<const char*>(start) + bytes; }

GLsizei indexCount(const TeLodArrays& arrays) {
  return GLsizei(arrays.shortIndices.size() + arrays.indices.size());
}

GLenum indexType(const TeLodArrays& arrays) {
  return arrays.shortIndices.empty() ? GL_UNSIGNED_INT : GL_UNSIGNED_SHORT;
}

} // namespace

std::int64_t TeLodSender::live() { return liveCount; }

void TeLodSender::begin(TeLodSubmission way, bool withColours) {
  m_way = way;
  m_withColours = withColours;
  GLint openList = 0;
  if (way == TeLodSubmission::DisplayLists)
    m_gl.getIntegerv(GL_LIST_INDEX, &openList);
  m_keeps = way != TeLodSubmission::VboStream && openList == 0;
  m_usesBuffers = way == TeLodSubmission::VboStatic || way == TeLodSubmission::VboDynamic ||
                  way == TeLodSubmission::VboStream;
  m_gl.pushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  // A neighbour's own vertex array object would take what follows.
  if (m_gl.bindVertexArray)
    m_gl.bindVertexArray(0);
  if (!m_usesBuffers) {
    m_gl.bindBuffer(GL_ARRAY_BUFFER, 0);
    m_gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  }
  m_gl.enableClientState(GL_VERTEX_ARRAY);
  m_gl.enableClientState(GL_NORMAL_ARRAY);
  if (withColours)
    m_gl.enableClientState(GL_COLOR_ARRAY);
  else
    m_gl.disableClientState(GL_COLOR_ARRAY);
}

void TeLodSender::end() { m_gl.popClientAttrib(); }

GLuint TeLodSender::makeBuffer(const void* data, std::size_t bytes, GLenum usage) {
  GLuint buffer = 0;
  m_gl.genBuffers(1, &buffer);
  liveCount++;
  m_gl.bindBuffer(GL_ARRAY_BUFFER, buffer);
  m_gl.bufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes), data, usage);
  m_bytesSent += std::int64_t(bytes);
  return buffer;
}

void TeLodSender::deleteBuffer(GLuint buffer) {
  if (!buffer)
    return;
  m_gl.deleteBuffers(1, &buffer);
  liveCount--;
}

TeLodSender::Kept TeLodSender::keep(TeLodArrays&& arrays) {
  Kept part;
  part.count = indexCount(arrays);
  part.indexType = indexType(arrays);
  part.triangles = arrays.triangles();
  if (m_way == TeLodSubmission::VertexArrays && part.count > 0)
    TeLodArrayMaker::expand(arrays);
  part.bytes = arrays.bytes();
  if (m_usesBuffers) {
    const GLenum usage = m_way == TeLodSubmission::VboStatic ? GL_STATIC_DRAW : GL_DYNAMIC_DRAW;
    part.vertices = makeBuffer(arrays.vertices.data(), arrays.vertexBytes(), usage);
    part.indices = makeBuffer(arrays.indexData(), arrays.indexBytes(), usage);
  } else if (m_way == TeLodSubmission::DisplayLists) {
    part.list = m_gl.genLists(1);
    liveCount++;
    m_gl.newList(part.list, GL_COMPILE);
    sendFromMemory(arrays);
    m_gl.endList();
    m_drawCalls--;
  } else {
    arrays.vertices.shrink_to_fit();
    part.arrays = std::move(arrays);
  }
  return part;
}

void TeLodSender::free(const Kept& part) {
  deleteBuffer(part.vertices);
  deleteBuffer(part.indices);
  if (part.list) {
    m_gl.deleteLists(part.list, 1);
    liveCount--;
  }
}

void TeLodSender::freeStream() {
  deleteBuffer(std::exchange(m_streamVertices, 0));
  deleteBuffer(std::exchange(m_streamIndices, 0));
}

void TeLodSender::pointAt(const void* vertices) const {
  constexpr GLsizei kStride = sizeof(TeDrawnVertex);
  m_gl.vertexPointer(3, GL_FLOAT, kStride, vertices);
  m_gl.normalPointer(GL_SHORT, kStride, after(vertices, offsetof(TeDrawnVertex, normal)));
  if (m_withColours)
    m_gl.colorPointer(4, GL_UNSIGNED_BYTE, kStride, after(vertices, offsetof(TeDrawnVertex, colour)));
}

void TeLodSender::draw(const Kept& part) {
  if (m_usesBuffers) {
    m_gl.bindBuffer(GL_ARRAY_BUFFER, part.vertices);
    pointAt(nullptr);
    m_gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, part.indices);
    m_gl.drawElements(GL_TRIANGLES, part.count, part.indexType, nullptr);
    m_drawCalls++;
  } else if (part.list) {
    m_gl.callList(part.list);
    m_drawCalls++;
  } else if (m_way == TeLodSubmission::Immediate) {
    sendCalls(part.arrays);
  } else {
    sendFromMemory(part.arrays);
  }
}

void TeLodSender::sendFromMemory(const TeLodArrays& arrays) {
  pointAt(arrays.vertices.data());
  if (arrays.indexBytes() > 0)
    m_gl.drawElements(GL_TRIANGLES, indexCount(arrays), indexType(arrays), arrays.indexData());
  else
    m_gl.drawArrays(GL_TRIANGLES, 0, GLsizei(arrays.vertices.size()));
  m_bytesSent += std::int64_t(arrays.bytes());
  m_drawCalls++;
}

void TeLodSender::sendCalls(const TeLodArrays& arrays) {
  const auto send = [&](const TeDrawnVertex& vertex) {
    if (m_withColours)
      m_gl.color4ubv(vertex.colour);
    m_gl.normal3sv(vertex.normal);
    m_gl.vertex3fv(vertex.position);
  };
  m_gl.begin(GL_TRIANGLES);
  if (arrays.indexBytes() == 0)
    for (const TeDrawnVertex& vertex : arrays.vertices)
      send(vertex);
  for (const std::uint16_t index : arrays.shortIndices)
    send(arrays.vertices[index]);
  for (const std::uint32_t index : arrays.indices)
    send(arrays.vertices[index]);
  m_gl.end();
  m_bytesSent += 3 * arrays.triangles() * std::int64_t(sizeof(TeDrawnVertex));
  m_drawCalls++;
}

void TeLodSender::drawOnce(const std::vector<TeLodArrays>& parts, std::size_t count) {
  if (count == 0)
    return;
  if (m_usesBuffers) {
    drawFromBuffers(parts, count);
    return;
  }
  for (std::size_t i = 0; i < count; i++) {
    if (m_way == TeLodSubmission::Immediate) {
      sendCalls(parts[i]);
    } else if (m_way == TeLodSubmission::VertexArrays && parts[i].indexBytes() > 0) {
      TeLodArrays expanded = parts[i];
      TeLodArrayMaker::expand(expanded);
      sendFromMemory(expanded);
    } else {
      sendFromMemory(parts[i]);
    }
  }
}

void TeLodSender::drawFromBuffers(const std::vector<TeLodArrays>& parts, std::size_t count) {
  const GLenum usage = m_way == TeLodSubmission::VboDynamic ? GL_DYNAMIC_DRAW : GL_STREAM_DRAW;
  std::size_t vertexBytes = 0, indexBytes = 0;
  for (std::size_t i = 0; i < count; i++) {
    vertexBytes += parts[i].vertexBytes();
    indexBytes += (parts[i].indexBytes() + 3) / 4 * 4;
  }
  if (!m_streamVertices) {
    m_streamVertices = makeBuffer(nullptr, 0, usage);
    m_streamIndices = makeBuffer(nullptr, 0, usage);
  }
  // New storage each time: the old one may still be read from.
  m_gl.bindBuffer(GL_ARRAY_BUFFER, m_streamVertices);
  m_gl.bufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertexBytes), nullptr, usage);
  m_gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_streamIndices);
  m_gl.bufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indexBytes), nullptr, usage);
  std::size_t vertexStart = 0, indexStart = 0;
  for (std::size_t i = 0; i < count; i++) {
    const TeLodArrays& part = parts[i];
    m_gl.bufferSubData(GL_ARRAY_BUFFER, GLintptr(vertexStart), GLsizeiptr(part.vertexBytes()),
                       part.vertices.data());
    m_gl.bufferSubData(GL_ELEMENT_ARRAY_BUFFER, GLintptr(indexStart), GLsizeiptr(part.indexBytes()),
                       part.indexData());
    vertexStart += part.vertexBytes();
    indexStart += (part.indexBytes() + 3) / 4 * 4;
    m_bytesSent += std::int64_t(part.bytes());
  }
  vertexStart = indexStart = 0;
  for (std::size_t i = 0; i < count; i++) {
    const TeLodArrays& part = parts[i];
    pointAt(offset(vertexStart));
    m_gl.drawElements(GL_TRIANGLES, indexCount(part), indexType(part), offset(indexStart));
    vertexStart += part.vertexBytes();
    indexStart += (part.indexBytes() + 3) / 4 * 4;
    m_drawCalls++;
  }
}
