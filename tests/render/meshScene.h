#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/TeSurfaceColours.h"
#include "nodes/terrain/SoTeTerrainMesh.h"
#include "nodes/terrain/TeMeshModelJob.h"
#include "nodes/terrain/TeStaticBlock.h"

#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>

#include <gtest/gtest.h>

#include <memory>
#include <utility>

inline TeStaticBlock meshBlock(TeWorld world, glm::dvec2 centre = {0, 0}, int patches = 3) {
  auto block = TeStaticBlock::build(std::move(world), centre, patches);
  EXPECT_TRUE(block) << (block ? "" : block.error().message);
  return std::move(*block);
}

/// Draws around a block's centre, which is the scene's origin.
inline std::shared_ptr<TeMeshDrawing> drawingOf(const TeStaticBlock& block) {
  auto drawing = std::make_shared<TeMeshDrawing>(block.centre());
  drawing->setWorldOrigin({block.centre(), 0});
  return drawing;
}

inline TeNodePtr<SoTeTerrainMesh> meshNode(const TePatchMesh& mesh, const TeSurfaceColours& colours,
                                           const std::shared_ptr<TeMeshDrawing>& drawing) {
  TeMeshModelJob job(std::make_shared<const TePatchMesh>(mesh), colours, drawing);
  TeAllowance allowance = TeAllowance::unlimited();
  EXPECT_TRUE(job.step(allowance));
  return job.take();
}

/// A block drawn by SoTeTerrainMesh: as teBlockGraph() draws it.
inline TeNodePtr<SoSeparator> meshGraph(const TeStaticBlock& block,
                                        const std::shared_ptr<TeMeshDrawing>& drawing) {
  TeNodePtr<SoSeparator> root(new SoSeparator);
  auto* hints = new SoShapeHints;
  hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  root->addChild(hints);
  root->addChild(drawing->translation());
  const TeSurfaceColours colours = TeSurfaceColours::forHeights(block.mean(), block.maximum());
  EXPECT_TRUE(block.forEachPiece(
      [&](const TePatchMesh& mesh) { root->addChild(meshNode(mesh, colours, drawing).get()); }));
  return root;
}

/// A scene around (0, 0, 0) seen from one side and above, lit by the sun.
inline TeNodePtr<SoSeparator> sideView(SoNode* graph, float distance = 90) {
  TeNodePtr<SoSeparator> scene(new SoSeparator);
  auto* camera = new SoPerspectiveCamera;
  camera->position = SbVec3f(0.6f, -0.65f, 0.45f) * distance;
  camera->pointAt(SbVec3f(0, 0, 0), SbVec3f(0, 0, 1));
  scene->addChild(camera);
  auto* sun = new SoDirectionalLight;
  sun->direction.setValue(-0.3f, 1, -0.8f);
  scene->addChild(sun);
  scene->addChild(graph);
  return scene;
}
