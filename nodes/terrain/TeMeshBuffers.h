#pragma once

#include "nodes/terrain/TeGridLevels.h"
#include "nodes/terrain/TeMeshGl.h"
#include "patchdb/TePatchMesh.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

/// The OpenGL buffers of the meshes of one TeMeshDrawing in one context: positions, the other attributes, and
/// indices, which whole grids of the same size share. Meshes are told apart by the address of their node.
///
/// Names of buffers stay valid in all contexts that share objects, and Coin gives such contexts one number;
/// vertex array objects do not, so none is used.
///
/// All calls with the context current, except retire() and bytes().
class TeMeshBuffers {
public:
  struct Mesh {
    GLuint positions = 0;     ///< relative to `anchor`
    GLuint nextPositions = 0; ///< relative to `nextAnchor`; 0 = none
    glm::dvec2 anchor{0};
    glm::dvec2 nextAnchor{0};
    GLuint attributes = 0;
    GLuint indices = 0;
    GLenum indexType = GL_UNSIGNED_SHORT;
    GLsizei indexCount = 0;
    std::size_t vertices = 0;
    std::size_t ownIndexBytes = 0; ///< 0 if shared
    std::pair<int, int> grid{0, 0};
  };

  explicit TeMeshBuffers(std::uint32_t context) : m_context(context), m_isUsable(m_gl.load(context)) {}
  TeMeshBuffers(const TeMeshBuffers&) = delete;
  TeMeshBuffers& operator=(const TeMeshBuffers&) = delete;

  std::uint32_t context() const { return m_context; }
  /// False: this OpenGL cannot draw meshes, and nothing may be added.
  bool isUsable() const { return m_isUsable; }

  /// Null if it was not added.
  Mesh* find(const void* node);
  /// Bytes that add() needs, without indices that are shared.
  static std::size_t addedBytes(const TePatchMesh& mesh);
  static std::size_t positionBytes(const TePatchMesh& mesh);
  /// Makes all buffers of a mesh that has triangles; `colours` as in teMeshAttributes().
  Mesh& add(const void* node, const TePatchMesh& mesh, const std::vector<std::uint32_t>& colours,
            glm::dvec2 anchor);
  /// Makes the positions anew.
  void setAnchor(Mesh& buffers, const TePatchMesh& mesh, glm::dvec2 anchor);
  /// Makes positions for an anchor besides those in use.
  void setNextAnchor(Mesh& buffers, const TePatchMesh& mesh, glm::dvec2 anchor);
  /// Uses the next positions, which then are the present ones; those take their place.
  void useNextAnchor(Mesh& buffers);
  void dropNextAnchor(Mesh& buffers);

  /// Whether a level of a mesh can be drawn.
  bool hasLevel(const Mesh& buffers, int level) const;
  /// Makes the indices of a coarser level, 1 .. levels.count(), which all whole grids of the size share.
  /// Bytes that were uploaded.
  std::size_t addLevel(const Mesh& buffers, const TeGridLevels& levels, int level);

  /// Draws with the state of the fixed-function pipeline, or the program, that is set; changes no state but
  /// the current colour and normal.
  void draw(const Mesh& buffers, bool withColours) const { draw(buffers, withColours, 0); }
  /// A level that was added; 0: all triangles.
  void draw(const Mesh& buffers, bool withColours, int level) const;

  /// Forgets a mesh; its buffers go with the next freeRetired(). True if there are such that were not there
  /// before.
  bool retire(const void* node);
  bool retireAll();
  void freeRetired();

  std::size_t bytes() const { return m_bytes; }

private:
  struct Indices {
    GLuint buffer = 0; ///< 0 = not made
    std::size_t bytes = 0;
    GLsizei count = 0;
  };
  struct Grid {
    std::vector<Indices> levels; ///< by level, all triangles first
    int uses = 0;
  };

  GLuint makeBuffer(const void* data, std::size_t bytes);
  void free(GLuint buffer, std::size_t bytes);
  void retireIndices(const Mesh& buffers);
  GLuint makeIndices(const TePatchMesh& mesh, GLenum type, std::size_t& bytes);

  std::uint32_t m_context;
  TeMeshGl m_gl;
  bool m_isUsable;
  std::unordered_map<const void*, Mesh> m_meshes;
  std::map<std::pair<int, int>, Grid> m_grids; ///< by columns and rows
  std::vector<std::pair<GLuint, std::size_t>> m_retired;
  std::size_t m_bytes = 0;
};
