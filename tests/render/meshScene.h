#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/TeSurfaceColours.h"
#include "nodes/terrain/SoTeTerrainMesh.h"
#include "nodes/terrain/TeMeshModelJob.h"
#include "nodes/terrain/TeStaticBlock.h"

#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>

#include <gtest/gtest.h>

#include <memory>

/// The mesh of each piece, coloured.
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
