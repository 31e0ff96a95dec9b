#include "nodes/terrain/TeMeshBuffers.h"

#include "nodes/terrain/TeMeshVertices.h"

#include <cassert>
#include <cstddef>
#include <limits>

namespace {

bool fitsShort(const TePatchMesh& mesh) {
  // The last number may stand for a restart of primitives.
  return mesh.positions.size() <= std::numeric_limits<std::uint16_t>::max();
}

std::size_t indexBytes(const TePatchMesh& mesh) {
  return 3 * std::size_t(teTriangleCount(mesh)) * (fitsShort(mesh) ? 2 : 4);
}

template <class Index> std::vector<Index> triangleIndices(const TePatchMesh& mesh) {
  std::vector<Index> indices;
  indices.reserve(3 * std::size_t(teTriangleCount(mesh)));
  teForEachTriangle(mesh, [&](std::size_t a, std::size_t b, std::size_t c) {
    indices.push_back(Index(a));
    indices.push_back(Index(b));
    indices.push_back(Index(c));
  });
  return indices;
}

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

} // namespace

TeMeshBuffers::Mesh* TeMeshBuffers::find(const void* node) {
  const auto found = m_meshes.find(node);
  return found == m_meshes.end() ? nullptr : &found->second;
}

std::size_t TeMeshBuffers::positionBytes(const TePatchMesh& mesh) {
  return mesh.positions.size() * sizeof(glm::vec3);
}

std::size_t TeMeshBuffers::addedBytes(const TePatchMesh& mesh) {
  return mesh.positions.size() * (sizeof(glm::vec3) + sizeof(TeVertexAttributes)) +
         (teIsWholeGrid(mesh) ? 0 : indexBytes(mesh));
}

TeMeshBuffers::Mesh& TeMeshBuffers::add(const void* node, const TePatchMesh& mesh,
                                        const std::vector<std::uint32_t>& colours, glm::dvec2 anchor) {
  assert(m_isUsable && !find(node) && !mesh.strips.empty());
  Mesh& buffers = m_meshes[node];
  buffers.vertices = mesh.positions.size();
  setAnchor(buffers, mesh, anchor);
  const std::vector<TeVertexAttributes> attributes = teMeshAttributes(mesh, colours);
  buffers.attributes = makeBuffer(attributes.data(), attributes.size() * sizeof(TeVertexAttributes));

  buffers.indexType = fitsShort(mesh) ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  buffers.indexCount = GLsizei(3 * teTriangleCount(mesh));
  if (!teIsWholeGrid(mesh)) {
    buffers.indices = makeIndices(mesh, buffers.indexType, buffers.ownIndexBytes);
    return buffers;
  }
  buffers.grid = {mesh.columns, mesh.rows};
  Grid& shared = m_grids[buffers.grid];
  if (shared.uses++ == 0) {
    Indices& all = shared.levels.emplace_back();
    all.buffer = makeIndices(mesh, buffers.indexType, all.bytes);
    all.count = buffers.indexCount;
  }
  buffers.indices = shared.levels.front().buffer;
  return buffers;
}

bool TeMeshBuffers::hasLevel(const Mesh& buffers, int level) const {
  if (level == 0)
    return true;
  const auto grid = m_grids.find(buffers.grid);
  return grid != m_grids.end() && std::size_t(level) < grid->second.levels.size() &&
         grid->second.levels[std::size_t(level)].buffer != 0;
}

std::size_t TeMeshBuffers::addLevel(const Mesh& buffers, const TeGridLevels& levels, int level) {
  assert(buffers.ownIndexBytes == 0 && level >= 1 && level <= levels.count() && !hasLevel(buffers, level));
  std::vector<Indices>& made = m_grids.find(buffers.grid)->second.levels;
  if (made.size() <= std::size_t(level))
    made.resize(std::size_t(level) + 1);
  Indices& indices = made[std::size_t(level)];
  const std::vector<std::uint32_t>& wide = levels.indices(level);
  indices.count = GLsizei(wide.size());
  if (buffers.indexType == GL_UNSIGNED_SHORT) {
    const std::vector<std::uint16_t> narrow(wide.begin(), wide.end());
    indices.bytes = narrow.size() * sizeof(std::uint16_t);
    indices.buffer = makeBuffer(narrow.data(), indices.bytes);
  } else {
    indices.bytes = wide.size() * sizeof(std::uint32_t);
    indices.buffer = makeBuffer(wide.data(), indices.bytes);
  }
  return indices.bytes;
}

void TeMeshBuffers::setAnchor(Mesh& buffers, const TePatchMesh& mesh, glm::dvec2 anchor) {
  if (buffers.positions)
    free(buffers.positions, positionBytes(mesh));
  const std::vector<glm::vec3> positions = teMeshPositions(mesh, anchor);
  buffers.positions = makeBuffer(positions.data(), positionBytes(mesh));
  buffers.anchor = anchor;
}

void TeMeshBuffers::setNextAnchor(Mesh& buffers, const TePatchMesh& mesh, glm::dvec2 anchor) {
  dropNextAnchor(buffers);
  const std::vector<glm::vec3> positions = teMeshPositions(mesh, anchor);
  buffers.nextPositions = makeBuffer(positions.data(), positionBytes(mesh));
  buffers.nextAnchor = anchor;
}

void TeMeshBuffers::useNextAnchor(Mesh& buffers) {
  std::swap(buffers.positions, buffers.nextPositions);
  std::swap(buffers.anchor, buffers.nextAnchor);
}

void TeMeshBuffers::dropNextAnchor(Mesh& buffers) {
  if (buffers.nextPositions)
    free(buffers.nextPositions, buffers.vertices * sizeof(glm::vec3));
  buffers.nextPositions = 0;
}

void TeMeshBuffers::draw(const Mesh& buffers, bool withColours, int level) const {
  GLuint indices = buffers.indices;
  GLsizei count = buffers.indexCount;
  if (level > 0) {
    const Indices& coarser = m_grids.find(buffers.grid)->second.levels[std::size_t(level)];
    indices = coarser.buffer;
    count = coarser.count;
  }
  m_gl.pushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  // A neighbour's own vertex array object would take what follows.
  if (m_gl.bindVertexArray)
    m_gl.bindVertexArray(0);
  m_gl.bindBuffer(GL_ARRAY_BUFFER, buffers.positions);
  m_gl.vertexPointer(3, GL_FLOAT, sizeof(glm::vec3), nullptr);
  m_gl.bindBuffer(GL_ARRAY_BUFFER, buffers.attributes);
  m_gl.normalPointer(GL_SHORT, sizeof(TeVertexAttributes), offset(offsetof(TeVertexAttributes, normal)));
  m_gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  m_gl.enableClientState(GL_VERTEX_ARRAY);
  m_gl.enableClientState(GL_NORMAL_ARRAY);
  if (withColours) {
    m_gl.colorPointer(4, GL_UNSIGNED_BYTE, sizeof(TeVertexAttributes),
                      offset(offsetof(TeVertexAttributes, colour)));
    m_gl.enableClientState(GL_COLOR_ARRAY);
  } else {
    m_gl.disableClientState(GL_COLOR_ARRAY);
  }
  m_gl.drawElements(GL_TRIANGLES, count, buffers.indexType, nullptr);
  m_gl.popClientAttrib();
}

bool TeMeshBuffers::retire(const void* node) {
  const auto found = m_meshes.find(node);
  if (found == m_meshes.end())
    return false;
  const bool isFirst = m_retired.empty();
  const Mesh& buffers = found->second;
  const std::size_t positions = buffers.vertices * sizeof(glm::vec3);
  m_retired.emplace_back(buffers.positions, positions);
  if (buffers.nextPositions)
    m_retired.emplace_back(buffers.nextPositions, positions);
  m_retired.emplace_back(buffers.attributes, buffers.vertices * sizeof(TeVertexAttributes));
  retireIndices(buffers);
  m_meshes.erase(found);
  return isFirst;
}

void TeMeshBuffers::retireIndices(const Mesh& buffers) {
  if (buffers.ownIndexBytes > 0) {
    m_retired.emplace_back(buffers.indices, buffers.ownIndexBytes);
    return;
  }
  const auto grid = m_grids.find(buffers.grid);
  if (--grid->second.uses > 0)
    return;
  for (const Indices& level : grid->second.levels)
    if (level.buffer)
      m_retired.emplace_back(level.buffer, level.bytes);
  m_grids.erase(grid);
}

bool TeMeshBuffers::retireAll() {
  const bool isFirst = m_retired.empty();
  while (!m_meshes.empty())
    retire(m_meshes.begin()->first);
  return isFirst && !m_retired.empty();
}

void TeMeshBuffers::freeRetired() {
  for (const auto& [buffer, bytes] : m_retired)
    free(buffer, bytes);
  m_retired.clear();
}

GLuint TeMeshBuffers::makeBuffer(const void* data, std::size_t bytes) {
  GLuint buffer = 0;
  m_gl.pushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  m_gl.genBuffers(1, &buffer);
  // Indices too: the binding for indices would be that of a neighbour's vertex array object.
  m_gl.bindBuffer(GL_ARRAY_BUFFER, buffer);
  m_gl.bufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes), data, GL_STATIC_DRAW);
  m_gl.popClientAttrib();
  m_bytes += bytes;
  return buffer;
}

void TeMeshBuffers::free(GLuint buffer, std::size_t bytes) {
  m_gl.deleteBuffers(1, &buffer);
  m_bytes -= bytes;
}

GLuint TeMeshBuffers::makeIndices(const TePatchMesh& mesh, GLenum type, std::size_t& bytes) {
  bytes = indexBytes(mesh);
  if (type == GL_UNSIGNED_SHORT)
    return makeBuffer(triangleIndices<std::uint16_t>(mesh).data(), bytes);
  return makeBuffer(triangleIndices<std::uint32_t>(mesh).data(), bytes);
}
