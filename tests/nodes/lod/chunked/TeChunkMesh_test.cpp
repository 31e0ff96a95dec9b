#include "nodes/lod/chunked/TeChunkMesh.h"
#include "tests/nodes/lod/lodTrials.h"

namespace {

constexpr int kCells = 64;

/// Heights of a mesh at all samples of a field; NaN where there is none.
class Surface {
public:
  explicit Surface(const TeLodMesh& mesh) : m_heights(std::size_t(kCells + 1) * (kCells + 1), NAN) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
      draw(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
           mesh.vertices[mesh.indices[i + 2]]);
  }
  double at(int column, int row) const { return m_heights[std::size_t(row * (kCells + 1) + column)]; }

private:
  void draw(const TeLodVertex& a, const TeLodVertex& b, const TeLodVertex& c) {
    const double area =
        double((b.column - a.column) * (c.row - a.row) - (c.column - a.column) * (b.row - a.row));
    const TeLatticeTriangle triangle(a, b, c);
    for (int row = triangle.firstRow(); row <= triangle.lastRow(); row++)
      for (int column = triangle.span(row).first; column <= triangle.span(row).last; column++) {
        const double wb =
            ((column - a.column) * (c.row - a.row) - (c.column - a.column) * (row - a.row)) / area;
        const double wc =
            ((b.column - a.column) * (row - a.row) - (column - a.column) * (b.row - a.row)) / area;
        m_heights[std::size_t(row * (kCells + 1) + column)] =
            (1 - wb - wc) * double(a.height) + wb * double(b.height) + wc * double(c.height);
      }
  }

  std::vector<double> m_heights;
};

TeLodMesh meshOf(TeChunkMesh& maker, const TeChunkPart& part) {
  TeLodMesh mesh;
  maker.append(part, mesh);
  EXPECT_EQ(mesh.triangles(), maker.triangles(part));
  return mesh;
}

} // namespace

// A chunk appears on its parent's surface, and moves in a straight way to its own.
TEST(TeChunkMesh, morphsFromTheParentsSurface) {
  std::mt19937 random(5);
  for (const StressField kind : {StressField::Rough, StressField::Spike, StressField::Cliff}) {
    const TeLodFieldPtr field = anyField(kind, kCells, random);
    const TeChunkTree tree(field, 8, -1);
    TeChunkMesh maker(tree);
    const double tolerance = 4 * maker.rounding();
    for (int level = 0; level + 1 < tree.levels(); level++)
      for (int y = 0; y < tree.chunks(level); y++)
        for (int x = 0; x < tree.chunks(level); x++) {
          TeChunkPart part, parent;
          part.level = level;
          part.x = x;
          part.y = y;
          parent.level = level + 1;
          parent.x = x / 2;
          parent.y = y / 2;
          const Surface above(meshOf(maker, parent)), own(meshOf(maker, part));
          part.weight = 0;
          const Surface start(meshOf(maker, part));
          part.weight = 64;
          const Surface between(meshOf(maker, part));
          const TeChunkTree::Square square = tree.square(level, x, y);
          double worst = 0;
          for (int row = square.row; row <= square.row + square.cells; row++)
            for (int column = square.column; column <= square.column + square.cells; column++) {
              ASSERT_NEAR(start.at(column, row), above.at(column, row), tolerance)
                  << level << " " << x << " " << y;
              ASSERT_NEAR(between.at(column, row), 0.75 * above.at(column, row) + 0.25 * own.at(column, row),
                          tolerance);
              worst =
                  std::max(worst, std::fabs(between.at(column, row) - double(field->height(column, row))));
            }
          ASSERT_LE(worst, maker.error(part));
        }
  }
}

TEST(TeChunkMesh, skirtsHangFromBordersAndFaceOutward) {
  std::mt19937 random(6);
  const TeLodFieldPtr field = anyField(StressField::Rough, kCells, random);
  const TeChunkTree tree(field, 8, -1);
  TeChunkMesh maker(tree);
  for (const int level : {0, 1, 2})
    for (int side = 0; side < 4; side++) {
      TeChunkPart part;
      part.level = level;
      part.x = 0;
      part.y = 0;
      part.x = side == 3 ? 1 : 0;
      part.y = side == 0 ? 1 : 0;
      part.morphing = true;
      part.beyond[std::size_t(side)] = TeChunkPart::Equal;
      const TeLodMesh mesh = meshOf(maker, part);
      const float depth = maker.skirtDepth(part, side);
      ASSERT_GT(depth, 0);
      ASSERT_EQ(std::int64_t(mesh.skirts.size() / 6),
                tree.chunk(level, part.x, part.y).borderEdges[std::size_t(side)]);
      const glm::dvec3 outward[] = {{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
      for (std::size_t i = 0; i < mesh.skirts.size(); i += 3) {
        glm::dvec3 corners[3];
        for (std::size_t k = 0; k < 3; k++) {
          const TeLodVertex& vertex = mesh.vertices[mesh.skirts[i + k]];
          corners[k] = {vertex.column, vertex.row, double(vertex.height)};
          const float own = field->height(vertex.column, vertex.row);
          ASSERT_TRUE(vertex.height == own || vertex.height == own - depth);
        }
        const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        ASSERT_NEAR(glm::dot(glm::normalize(normal), outward[side]), 1, 1e-9);
      }
    }
}
