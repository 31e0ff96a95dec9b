#include "nodes/lod/brute/TeBruteForce.h"

#include "nodes/lod/TePerspectiveView.h"
#include "nodes/lod/lodTrials.h"

TEST(TeBruteForce, IsTheSurfaceOfAllSamplesSplitFromSouthWestToNorthEast) {
  std::mt19937 random(3);
  const TeLodFieldPtr field = anyField(StressField::Rough, 64, random);
  TeBruteForce brute(field);
  ASSERT_TRUE(brute.select(viewFrom(glm::dvec3(0)), {}));
  EXPECT_EQ(brute.selection().triangles, 2 * 64 * 64);
  EXPECT_EQ(brute.selection().errorBound, 0);
  TeLodMesh mesh;
  brute.appendMesh(mesh);
  EXPECT_EQ(mesh.triangles(), brute.selection().triangles);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const TeLodVertex& a = mesh.vertices[mesh.indices[i]];
    bool rises = false; // an edge of each triangle
    for (int corner = 0; corner < 3; corner++) {
      const TeLodVertex& p = mesh.vertices[mesh.indices[i + std::size_t(corner)]];
      const TeLodVertex& q = mesh.vertices[mesh.indices[i + std::size_t(corner + 1) % 3]];
      ASSERT_LE(std::abs(p.column - a.column) + std::abs(p.row - a.row), 2);
      ASSERT_EQ(p.height, field->height(p.column, p.row));
      rises = rises || (std::abs(p.column - q.column) == 1 && p.column - q.column == p.row - q.row);
    }
    ASSERT_TRUE(rises);
  }
}

TEST(TeBruteForce, LeavesOutPatchesThatAreNotInView) {
  std::mt19937 random(4);
  const TeLodFieldPtr field = anyField(StressField::Rough, 256, random);
  TeBruteForce brute(field);
  TePerspectiveView camera;
  camera.eye = field->position(128, 128, double(field->highest()) + 50);
  camera.forward = glm::normalize(glm::dvec3(0.2, 1, -0.2));
  const TeLodView view = camera.lodView();
  brute.select(view, {});
  EXPECT_GT(brute.selection().culled, 10);
  EXPECT_EQ(brute.selection().visited, 64);
  TeLodMesh mesh;
  brute.appendMesh(mesh);
  const TeScreenError::Report report = measured(*field, mesh, view);
  EXPECT_GT(report.samples, 1000);
  EXPECT_EQ(report.uncovered, 0);
  EXPECT_EQ(report.worst, 0);
}

TEST(TeBruteForce, HasTerrainOfAFewSamples) {
  std::mt19937 random(5);
  TeBruteForce brute(anyField(StressField::Rough, 2, random));
  brute.select(viewFrom(glm::dvec3(0)), {});
  EXPECT_EQ(brute.selection().triangles, 8);
  EXPECT_GE(brute.bytesPerSample(), 4);
}
