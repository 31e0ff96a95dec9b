#pragma once

#include "nodes/terrain/TeMeshDrawing.h"
#include "patchdb/TePatchData.h"

#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoSubNode.h>

#include <cstdint>
#include <memory>
#include <vector>

/// Draws one piece of the surface from OpenGL buffers of its own. (What Coin's own nodes would cost:
/// docs/engine-scene.md.) Works with the lights, fog, textures, draw styles and shaders of the scene around
/// it, is picked, counted, and gives its triangles like any shape.
///
/// It has no fields: an engine makes such nodes while it runs, and they are not written to files; what is to
/// be kept is made by TePatchGraphBuilder.
class SoTeTerrainMesh : public SoShape {
  typedef SoShape inherited;
  SO_NODE_HEADER(SoTeTerrainMesh);

public:
  static void initClass();
  SoTeTerrainMesh();

  /// `colours`: packed RGBA, one a vertex. The buffers are made when it is first drawn or culled, in
  /// every context.
  void setMesh(TePatchMeshPtr mesh, std::vector<std::uint32_t> colours,
               std::shared_ptr<TeMeshDrawing> drawing);
  const TePatchMeshPtr& mesh() const { return m_mesh; }
  /// What drawing it for the first time uploads.
  std::size_t uploadBytes() const;

  void GLRender(SoGLRenderAction* action) override;
  void rayPick(SoRayPickAction* action) override;
  void getPrimitiveCount(SoGetPrimitiveCountAction* action) override;

protected:
  ~SoTeTerrainMesh() override;
  void generatePrimitives(SoAction* action) override;
  void computeBBox(SoAction* action, SbBox3f& box, SbVec3f& center) override;

private:
  TePatchMeshPtr m_mesh;
  std::vector<std::uint32_t> m_colours;
  std::shared_ptr<TeMeshDrawing> m_drawing;
};
