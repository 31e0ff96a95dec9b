#include "nodes/terrain/TeMeshModelJob.h"

#include "nodes/gridMesh.h"

#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>

#include <gtest/gtest.h>

namespace {

TePatchMeshPtr hills(int side) {
  return std::make_shared<const TePatchMesh>(
      gridMesh(*TeLattice::create(257, 1), 0, 0, side, side,
               [](double x, double y) { return float(0.02 * x + 0.03 * y); }));
}

/// Diffuse colours of all corners of all triangles.
std::vector<SbColor> coloursOf(SoNode* node) {
  std::vector<SbColor> colours;
  SoCallbackAction action;
  action.addTriangleCallback(
      SoTeTerrainMesh::getClassTypeId(),
      [](void* data, SoCallbackAction* action, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
         const SoPrimitiveVertex* c) {
        for (const SoPrimitiveVertex* vertex : {a, b, c}) {
          SbColor ambient, diffuse, specular, emission;
          float shininess, transparency;
          action->getMaterial(ambient, diffuse, specular, emission, shininess, transparency,
                              vertex->getMaterialIndex());
          static_cast<std::vector<SbColor>*>(data)->push_back(diffuse);
        }
      },
      &colours);
  action.apply(node);
  return colours;
}

} // namespace

TEST(TeMeshModelJob, SlicesMakeTheSameNodeAsOneGo) {
  const TePatchMeshPtr mesh = hills(127);
  const TeSurfaceColours colours;
  const auto drawing = std::make_shared<TeMeshDrawing>(glm::dvec2(0));
  TeMeshModelJob whole(mesh, colours, drawing);
  TeAllowance unlimited = TeAllowance::unlimited();
  EXPECT_TRUE(whole.step(unlimited));

  TeMeshModelJob sliced(mesh, colours, drawing);
  int slices = 0;
  bool isDone = false;
  while (!isDone) {
    TeAllowance unit = TeAllowance::units(1);
    isDone = sliced.step(unit);
    EXPECT_EQ(unit.unitsSpent(), 1);
    slices++;
  }
  EXPECT_EQ(slices, (127 * 127 + 4095) / 4096);

  const auto a = whole.take();
  const auto b = sliced.take();
  EXPECT_EQ(a->mesh(), mesh);
  const std::vector<SbColor> expected = coloursOf(a.get());
  ASSERT_EQ(expected.size(), 3u * 2 * 126 * 126);
  EXPECT_EQ(coloursOf(b.get()), expected);
  EXPECT_NE(expected.front(), expected.back()); // from grass to rock
}

TEST(TeMeshModelJob, AMeshWithoutVerticesIsDoneAtOnce) {
  const auto drawing = std::make_shared<TeMeshDrawing>(glm::dvec2(0));
  TeMeshModelJob job(std::make_shared<const TePatchMesh>(), TeSurfaceColours(), drawing);
  TeAllowance unit = TeAllowance::units(1);
  EXPECT_TRUE(job.step(unit));
  EXPECT_EQ(job.take()->uploadBytes(), 0u);
}

TEST(TeMeshModelJob, FindsTheErrorsOfLevelsOnlyIfOneIsWanted) {
  const TePatchMeshPtr mesh = hills(31);
  const auto drawing = std::make_shared<TeMeshDrawing>(glm::dvec2(0));
  TeAllowance unlimited = TeAllowance::unlimited();
  TeMeshModelJob plain(mesh, TeSurfaceColours(), drawing);
  ASSERT_TRUE(plain.step(unlimited));
  EXPECT_TRUE(plain.take()->levelErrors().empty());
  drawing->setPixelError(1);
  TeMeshModelJob wanted(mesh, TeSurfaceColours(), drawing);
  drawing->setPixelError(0); // what a job has begun it ends
  int units = 0;
  for (bool isDone = false; !isDone; ++units) {
    TeAllowance unit = TeAllowance::units(1);
    isDone = wanted.step(unit);
  }
  EXPECT_GT(units, 1);
  EXPECT_EQ(int(wanted.take()->levelErrors().size()), TeGridLevels(31, 31).count() + 1);
}
