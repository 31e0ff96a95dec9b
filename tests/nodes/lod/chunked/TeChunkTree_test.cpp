#include "nodes/lod/chunked/TeChunkMesh.h"
#include "nodes/lod/chunked/TeChunkPart.h"
#include "nodes/lod/chunked/TeChunkTree.h"
#include "tests/nodes/lod/lodTrials.h"

namespace {

constexpr int kCells = 64;

} // namespace

// Each chunk's numbers are those of its mesh.
TEST(TeChunkTree, knowsItsMeshes) {
  std::mt19937 random(2);
  for (const StressField kind : {StressField::Rough, StressField::Spike, StressField::Plateau}) {
    const TeLodFieldPtr field = anyField(kind, kCells, random);
    const TeChunkTree tree(field, 8, -1);
    ASSERT_EQ(tree.levels(), 4);
    TeChunkMesh maker(tree);
    TeLodView straightDown; // sees everything in samples' units
    straightDown.perspective = false;
    straightDown.focal = 1;
    for (int level = 0; level < tree.levels(); level++) {
      for (int y = 0; y < tree.chunks(level); y++)
        for (int x = 0; x < tree.chunks(level); x++) {
          SCOPED_TRACE(testing::Message() << "chunk " << level << " " << x << " " << y);
          const TeChunkTree::Chunk& chunk = tree.chunk(level, x, y);
          TeChunkPart part;
          part.level = level;
          part.x = x;
          part.y = y;
          TeLodMesh mesh;
          maker.append(part, mesh);
          ASSERT_EQ(std::int64_t(mesh.indices.size() / 3), std::int64_t(chunk.triangles));
          ASSERT_TRUE(mesh.skirts.empty());
          TeScreenError error(field->heights(), {0, 0, 0}, 1, 1);
          TeWatertight watertight(kCells);
          addTo(watertight, *field, mesh);
          ASSERT_EQ(watertight.doubleArea(), 2ll * tree.cells(level) * tree.cells(level));
          ASSERT_EQ(watertight.slivers(), 0);
          for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            error.add(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
                      mesh.vertices[mesh.indices[i + 2]]);
          const TeScreenError::Report report = error.measure(straightDown);
          ASSERT_NEAR(report.worstMetres, double(chunk.error), 1e-5 * (1 + double(chunk.error)));
          ASSERT_LE(chunk.error, tree.levelError(level) * 1.000001f);
          const TeLodBox box = tree.box(level, x, y);
          for (const TeLodVertex& vertex : mesh.vertices) {
            const glm::dvec3 at = field->position(vertex);
            for (int axis = 0; axis < 3; axis++) {
              ASSERT_GE(at[axis], box.low[axis]);
              ASSERT_LE(at[axis], box.high[axis]);
            }
          }
        }
      if (level > 1) {
        ASSERT_EQ(tree.levelError(level), 2 * tree.levelError(level - 1));
      }
    }
  }
}

// So chunks of one level need no skirts between them.
TEST(TeChunkTree, chunksOfALevelFit) {
  std::mt19937 random(3);
  const TeLodFieldPtr field = anyField(StressField::Rough, kCells, random);
  const TeChunkTree tree(field, 8, -1);
  TeChunkMesh maker(tree);
  for (int level = 0; level < tree.levels(); level++) {
    TeWatertight mesh(kCells);
    for (int y = 0; y < tree.chunks(level); y++)
      for (int x = 0; x < tree.chunks(level); x++) {
        TeChunkPart part;
        part.level = level;
        part.x = x;
        part.y = y;
        TeLodMesh triangles;
        maker.append(part, triangles);
        addTo(mesh, *field, triangles);
      }
    EXPECT_EQ(mesh.cracks(), 0) << level;
    EXPECT_TRUE(mesh.coversSquare());
  }
}

TEST(TeChunkTree, aFlatTerrainIsTwoTriangles) {
  std::mt19937 random(4);
  const TeChunkTree tree(anyField(StressField::Flat, 256, random), 16, -1);
  EXPECT_EQ(tree.chunk(tree.levels() - 1, 0, 0).triangles, 2);
  EXPECT_EQ(tree.chunk(tree.levels() - 1, 0, 0).error, 0);
}
