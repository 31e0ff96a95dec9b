#include "apps/terrane-accuracy/TeRawMesh.h"

#include <GL/glext.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLLazyElement.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <type_traits>
#include <vector>

struct TeRawMesh::Gl {
  void (*genBuffers)(GLsizei, GLuint*) = nullptr;
  void (*deleteBuffers)(GLsizei, const GLuint*) = nullptr;
  void (*bindBuffer)(GLenum, GLuint) = nullptr;
  void (*bufferData)(GLenum, GLsizeiptr, const void*, GLenum) = nullptr;
  void (*vertexPointer)(GLint, GLenum, GLsizei, const void*) = nullptr;
  void (*normalPointer)(GLenum, GLsizei, const void*) = nullptr;
  void (*enableClientState)(GLenum) = nullptr;
  void (*disableClientState)(GLenum) = nullptr;
  void (*drawElements)(GLenum, GLsizei, GLenum, const void*) = nullptr;

  bool load(const TeContext& context) {
    bool all = true;
    const auto find = [&](const char* name, auto*& function) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(context.procAddress(name));
      all = all && function;
    };
    find("glGenBuffers", genBuffers);
    find("glDeleteBuffers", deleteBuffers);
    find("glBindBuffer", bindBuffer);
    find("glBufferData", bufferData);
    find("glVertexPointer", vertexPointer);
    find("glNormalPointer", normalPointer);
    find("glEnableClientState", enableClientState);
    find("glDisableClientState", disableClientState);
    find("glDrawElements", drawElements);
    return all;
  }
};

namespace {

glm::vec3 normalAt(const TeLodField& field, int column, int row) {
  const auto at = [&](int x, int y) {
    return double(field.height(std::clamp(x, 0, field.cells()), std::clamp(y, 0, field.cells()))) *
           field.heightScale();
  };
  const double east = (at(column + 1, row) - at(column - 1, row)) / (2 * field.spacing());
  const double north = (at(column, row + 1) - at(column, row - 1)) / (2 * field.spacing());
  return glm::normalize(glm::dvec3(-east, -north, 1));
}

} // namespace

TeResult<std::unique_ptr<TeRawMesh>> TeRawMesh::create(TeContext& context) {
  std::unique_ptr<TeRawMesh> mesh(new TeRawMesh(context));
  if (!mesh->m_gl->load(context))
    return TeError{std::string(context.name()) + ": OpenGL without vertex buffers"};
  mesh->m_gl->genBuffers(2, mesh->m_buffers);
  return mesh;
}

TeRawMesh::TeRawMesh(TeContext& context)
    : m_context(context), m_gl(std::make_unique<Gl>()), m_node(new SoCallback) {
  m_node->setCallback(onAction, this);
}

TeRawMesh::~TeRawMesh() {
  m_node->setCallback(nullptr);
  if (m_buffers[0] != 0 && m_context.makeCurrent())
    m_gl->deleteBuffers(2, m_buffers);
}

void TeRawMesh::load(const TeLodMesh& mesh, const TeLodField& field) {
  std::vector<float> vertices;
  vertices.reserve(6 * mesh.vertices.size());
  for (const TeLodVertex& vertex : mesh.vertices) {
    const glm::vec3 position(field.position(vertex));
    const glm::vec3 normal = normalAt(field, vertex.column, vertex.row);
    vertices.insert(vertices.end(), {position.x, position.y, position.z, normal.x, normal.y, normal.z});
  }
  std::vector<std::uint32_t> indices = mesh.indices;
  indices.insert(indices.end(), mesh.skirts.begin(), mesh.skirts.end());
  m_count = GLsizei(indices.size());
  m_gl->bindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
  m_gl->bufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(float)), vertices.data(),
                   GL_STATIC_DRAW);
  m_gl->bindBuffer(GL_ARRAY_BUFFER, m_buffers[1]);
  m_gl->bufferData(GL_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(std::uint32_t)), indices.data(),
                   GL_STATIC_DRAW);
  m_gl->bindBuffer(GL_ARRAY_BUFFER, 0);
}

void TeRawMesh::onAction(void* mesh, SoAction* action) {
  if (action->isOfType(SoGLRenderAction::getClassTypeId()))
    static_cast<const TeRawMesh*>(mesh)->draw(action->getState());
}

void TeRawMesh::draw(SoState* state) const {
  constexpr GLsizei kStride = 6 * sizeof(float);
  SoGLLazyElement::getInstance(state)->send(state, SoLazyElement::ALL_MASK);
  m_gl->bindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
  m_gl->vertexPointer(3, GL_FLOAT, kStride, nullptr);
  m_gl->normalPointer(GL_FLOAT, kStride, reinterpret_cast<const void*>(3 * sizeof(float)));
  m_gl->enableClientState(GL_VERTEX_ARRAY);
  m_gl->enableClientState(GL_NORMAL_ARRAY);
  m_gl->bindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[1]);
  m_gl->drawElements(GL_TRIANGLES, m_count, GL_UNSIGNED_INT, nullptr);
  m_gl->disableClientState(GL_VERTEX_ARRAY);
  m_gl->disableClientState(GL_NORMAL_ARRAY);
  m_gl->bindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  m_gl->bindBuffer(GL_ARRAY_BUFFER, 0);
}
