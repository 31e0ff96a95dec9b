#pragma once

#include "nodes/terrain/TeMeshDrawing.h"
#include "patchdb/TePatchData.h"

#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoSubNode.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <vector>

/// Draws one piece of the surface from OpenGL buffers of its own. (What Coin's own nodes would cost:
/// docs/engine-scene.md.) Works with the lights, fog, textures, draw styles and shaders of the scene around
/// it, is picked (SoTeTerrainDetail), counted, and gives its triangles like any shape. The mesh's colours
/// take the place of the material's diffuse colour and transparency, unless that is overridden. Triangles are
/// counter-clockwise seen from above. Textures need a SoTextureCoordinateFunction before it; its coordinates,
/// like the node's own, are relative to the drawing's anchor.
///
/// With a pixel error (TeMeshDrawing::setPixelError()) a mesh without missing cells is drawn with fewer
/// triangles where it is far away; its rim is always complete, so that what lies beside it fits. It changes
/// to a coarser level only if that is within 1 / kSwitch of what is allowed: an eye that trembles changes
/// nothing. Picking, counting and triangles that are given stay those of the complete mesh.
///
/// It has no fields: an engine makes such nodes while it runs, and they are not written to files; what is to
/// be kept is made by TePatchGraphBuilder. Copies share the mesh and the drawing.
class SoTeTerrainMesh : public SoShape {
  typedef SoShape inherited;
  SO_NODE_HEADER(SoTeTerrainMesh);

public:
  static void initClass();
  SoTeTerrainMesh();

  /// `colours`: packed as Coin does (0xRRGGBBAA), one a vertex; any other number of them means the
  /// material's. The buffers are made when it is first drawn or culled, in every context.
  void setMesh(TePatchMeshPtr mesh, std::vector<std::uint32_t> colours,
               std::shared_ptr<TeMeshDrawing> drawing);
  /// Null at first: nothing is drawn.
  const TePatchMeshPtr& mesh() const { return m_mesh; }
  /// By level of TeGridLevels of the mesh's columns and rows, from 0 on: the largest deviation of a sample,
  /// metres (TeLevelErrors). A mesh that has none finds them when it is drawn with a pixel error, a few
  /// meshes in a frame.
  void setLevelErrors(std::vector<float> errors);
  const std::vector<float>& levelErrors() const { return m_errors; }
  /// That it was last drawn with; 0 = all triangles.
  int level() const { return m_level; }
  static constexpr double kSwitch = 1.1;
  /// What drawing it for the first time uploads, without indices that it may share with other meshes.
  std::size_t uploadBytes() const;

  void GLRender(SoGLRenderAction* action) override;
  void rayPick(SoRayPickAction* action) override;
  void getPrimitiveCount(SoGetPrimitiveCountAction* action) override;
  void copyContents(const SoFieldContainer* from, SbBool copyConnections) override;

protected:
  ~SoTeTerrainMesh() override;
  void generatePrimitives(SoAction* action) override;
  void computeBBox(SoAction* action, SbBox3f& box, SbVec3f& center) override;

private:
  bool isEmpty() const { return !m_mesh || m_mesh->strips.empty(); }
  SbVec3f position(std::size_t vertex) const;
  SbBox3f box() const;
  /// Makes the mesh's colours those of the state. False if they are not to be used.
  bool setColours(SoState* state);
  void findBox();
  /// False: it has no coarser levels, or not yet.
  bool findErrors();
  /// The level for the state's camera, whose error counts as the frame's.
  int chooseLevel(SoState* state);

  TePatchMeshPtr m_mesh;
  std::vector<std::uint32_t> m_colours;
  std::shared_ptr<TeMeshDrawing> m_drawing;
  std::int64_t m_triangles = 0;
  std::vector<float> m_errors; ///< empty: not known
  std::shared_ptr<const TeGridLevels> m_levels;
  int m_level = 0;
  glm::vec3 m_lowest{0}; ///< corner of the box around all triangles, relative to the mesh's origin
  glm::vec3 m_highest{0};
};
