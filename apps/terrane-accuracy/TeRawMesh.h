#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/context/TeContext.h"
#include "nodes/lod/TeLodField.h"

#include <Inventor/nodes/SoCallback.h>

#include <memory>

class SoState;

/// The same triangles in plain OpenGL, to compare frame times with: one buffer of vertices with normals, one
/// of indices, fixed functions, uploaded once. In one context, which must outlive it.
class TeRawMesh {
public:
  /// Error: an OpenGL without buffers.
  static TeResult<std::unique_ptr<TeRawMesh>> create(TeContext& context);
  ~TeRawMesh();
  TeRawMesh(const TeRawMesh&) = delete;
  TeRawMesh& operator=(const TeRawMesh&) = delete;

  /// Replaces the triangles; skirts are drawn, too. The context must be current.
  void load(const TeLodMesh& mesh, const TeLodField& field);
  /// Draws them, as a node of a scene.
  SoNode* node() { return m_node.get(); }

private:
  struct Gl;

  explicit TeRawMesh(TeContext& context);
  static void onAction(void* mesh, SoAction* action);
  void draw(SoState* state) const;

  TeContext& m_context;
  std::unique_ptr<Gl> m_gl;
  TeNodePtr<SoCallback> m_node;
  GLuint m_buffers[2] = {};
  GLsizei m_count = 0;
};
