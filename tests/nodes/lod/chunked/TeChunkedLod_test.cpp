#include "nodes/lod/TeLodMethods.h"
#include "nodes/lod/chunked/TeChunkedLod.h"
#include "tests/nodes/lod/lodTrials.h"

#include <array>

namespace {

std::unique_ptr<TeLodMethod> methodOver(TeLodFieldPtr field, int leafCells = 16) {
  TeChunkedLod::Settings settings;
  settings.leafCells = leafCells;
  return std::move(TeChunkedLod::create(std::move(field), settings).value());
}

/// What is drawn along the lines between cells: for each edge of a cell and each of the two sides of its line
/// the heights of the surface at both ends, and of the lower end of its wall.
class Borders {
public:
  explicit Borders(int cells) : m_cells(cells), m_edges(std::size_t(4 * (cells + 1) * (cells + 1))) {}

  void add(const TeLodMesh& mesh, const TeChunkTree::Square& square) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
      for (std::size_t k = 0; k < 3; k++) {
        const TeLodVertex& from = mesh.vertices[mesh.indices[i + k]];
        const TeLodVertex& to = mesh.vertices[mesh.indices[i + (k + 1) % 3]];
        const bool south = from.row == square.row && to.row == square.row;
        const bool north = from.row == square.row + square.cells && to.row == from.row;
        const bool west = from.column == square.column && to.column == square.column;
        const bool east = from.column == square.column + square.cells && to.column == from.column;
        if (south || north || west || east)
          along(from, to, [](Edge& edge, int end, double height) { edge.top[std::size_t(end)] = height; });
      }
    for (std::size_t i = 0; i < mesh.skirts.size(); i += 6) {
      const TeLodVertex &below = mesh.vertices[mesh.skirts[i]], &end = mesh.vertices[mesh.skirts[i + 1]];
      ASSERT_LT(below.height, mesh.vertices[mesh.skirts[i + 5]].height);
      ASSERT_LT(end.height, mesh.vertices[mesh.skirts[i + 2]].height);
      along(below, end, [](Edge& edge, int at, double height) { edge.bottom[std::size_t(at)] = height; });
    }
  }

  struct Gaps {
    int compared = 0; ///< ends of edges with a surface on both sides
    int open = 0;     ///< where they differ
    int uncovered = 0;
  };
  Gaps gaps() const {
    Gaps gaps;
    for (int row = 0; row <= m_cells; row++)
      for (int column = 0; column <= m_cells; column++) {
        compare(edge(0, column, row), edge(2, column, row), gaps);
        compare(edge(1, column, row), edge(3, column, row), gaps);
      }
    return gaps;
  }

private:
  struct Edge {
    std::array<double, 2> top{NAN, NAN};    ///< at its western or southern end, and the other
    std::array<double, 2> bottom{NAN, NAN}; ///< NaN: no wall
  };
  /// Of a side of parts (south, east, north, west), at the cell edge that begins at a sample.
  const Edge& edge(int side, int column, int row) const {
    return m_edges[std::size_t((row * (m_cells + 1) + column) * 4 + side)];
  }

  template <class Set> void along(const TeLodVertex& from, const TeLodVertex& to, Set set) {
    const int dx = (to.column > from.column) - (to.column < from.column);
    const int dy = (to.row > from.row) - (to.row < from.row);
    const int side = dx > 0 ? 0 : dy > 0 ? 1 : dx < 0 ? 2 : 3; // counter-clockwise around the part
    const int steps = std::max(std::abs(to.column - from.column), std::abs(to.row - from.row));
    for (int i = 0; i < steps; i++)
      for (int end = 0; end < 2; end++) {
        const double height =
            double(from.height) + (double(to.height) - double(from.height)) * (i + end) / steps;
        const bool backward = dx + dy < 0;
        const int first = backward ? i + 1 : i; // of the cell edge's own first end
        Edge& edge = m_edges[std::size_t(
            ((from.row + dy * first) * (m_cells + 1) + from.column + dx * first) * 4 + side)];
        set(edge, backward ? 1 - end : end, height);
      }
  }

  static void compare(const Edge& a, const Edge& b, Gaps& gaps) {
    for (std::size_t end = 0; end < 2; end++) {
      if (std::isnan(a.top[end]) || std::isnan(b.top[end]))
        continue;
      gaps.compared++;
      if (a.top[end] == b.top[end])
        continue;
      gaps.open++;
      const Edge& higher = a.top[end] > b.top[end] ? a : b;
      const Edge& lower = a.top[end] > b.top[end] ? b : a;
      gaps.uncovered += !(higher.bottom[end] <= lower.top[end]); // also where there is no wall
    }
  }

  int m_cells;
  std::vector<Edge> m_edges;
};

} // namespace

// Along all lines where chunks meet the wall of the higher one reaches down to the lower one: no ray passes.
TEST(TeChunkedLod, skirtsCoverEveryGap) {
  std::mt19937 random(5);
  std::int64_t compared = 0, open = 0, wide = 0;
  for (int kind = 0; kind <= int(StressField::Flat); kind++)
    for (const auto& [cells, leafCells] : {std::pair(64, 4), std::pair(128, 8)}) {
      const TeLodFieldPtr field = anyField(StressField(kind), cells, random);
      const auto method = methodOver(field, leafCells);
      const TeChunkTree& tree = static_cast<const TeChunkedLod&>(*method).tree();
      for (int camera = 0; camera < 100; camera++) {
        method->select(anyView(*field, camera % 2 == 0, random), anyAccuracy(random));
        Borders borders(cells);
        for (std::size_t i = 0; i < method->selection().parts.size(); i++) {
          const TeChunkPart part = TeChunkPart::of(method->selection().parts[i].key);
          for (const int beyond : part.beyond)
            wide += beyond > TeChunkPart::Coarser;
          TeLodMesh mesh;
          method->appendPart(i, mesh);
          borders.add(mesh, tree.square(part.level, part.x, part.y));
        }
        const Borders::Gaps gaps = borders.gaps();
        ASSERT_EQ(gaps.uncovered, 0) << "field " << kind << " camera " << camera;
        compared += gaps.compared;
        open += gaps.open;
      }
    }
  EXPECT_GT(open, 10000);
  EXPECT_GT(wide, 100); // chunks beside others that are several levels coarser
  std::printf("%lld places where chunks meet, %lld of them apart: all behind skirts\n",
              static_cast<long long>(compared), static_cast<long long>(open));
}

TEST(TeChunkedLod, itsBoundHolds) {
  std::mt19937 random(6);
  expectThatBoundsHold([](const TeLodFieldPtr& field) { return methodOver(field, 8); }, random);
}

TEST(TeChunkedLod, coversTheSquare) {
  std::mt19937 random(7);
  for (int cells = 2; cells <= 256; cells *= 2) {
    const TeLodFieldPtr field = anyField(StressField::Rough, cells, random);
    const auto method = TeLodMethods::create("chunked", field);
    ASSERT_TRUE(method);
    EXPECT_EQ((*method)->name(), "chunked");
    for (int camera = 0; camera < 10; camera++) {
      (*method)->select(anyView(*field, true, random), anyAccuracy(random));
      TeWatertight mesh(cells);
      addTo(mesh, *field, meshOf(**method));
      EXPECT_TRUE(mesh.coversSquare());
      EXPECT_EQ(mesh.slivers(), 0);
    }
  }
}

TEST(TeChunkedLod, noErrorMeansEverySample) {
  std::mt19937 random(8);
  const TeLodFieldPtr field = anyField(StressField::Plateau, 64, random);
  const auto method = methodOver(field);
  for (const bool geomorph : {false, true}) {
    TeLodAccuracy exact;
    exact.pixelError = 0;
    exact.geomorph = geomorph;
    method->select(anyView(*field, true, random), exact);
    const TeLodMesh mesh = meshOf(*method);
    EXPECT_EQ(mesh.indices.size() / 3, 2u * 64 * 64);
    EXPECT_EQ(method->selection().errorBound, 0);
    TeWatertight watertight(64);
    addTo(watertight, *field, mesh);
    EXPECT_EQ(watertight.cracks(), 0);
  }
}

TEST(TeChunkedLod, refusesOtherChunks) {
  std::mt19937 random(9);
  const TeLodFieldPtr field = anyField(StressField::Flat, 64, random);
  for (const int cells : {0, 1, 12, 512}) {
    TeChunkedLod::Settings settings;
    settings.leafCells = cells;
    const auto method = TeChunkedLod::create(field, settings);
    ASSERT_FALSE(method);
    EXPECT_NE(method.error().message.find(std::to_string(cells)), std::string::npos);
  }
  TeChunkedLod::Settings settings;
  settings.firstError = std::nan("");
  EXPECT_FALSE(TeChunkedLod::create(field, settings));
}

TEST(TeChunkedLod, lowersTheAccuracyForABudget) {
  std::mt19937 random(10);
  const TeLodFieldPtr field = anyField(StressField::Rough, 256, random);
  const auto method = methodOver(field);
  expectThatABudgetIsKept(*method);
  EXPECT_EQ(method->selection().parts.size(), 1u) << "the root, if even that is too much";
}

TEST(TeChunkedLod, keysStandForTriangles) {
  std::mt19937 random(11);
  const TeLodFieldPtr field = anyField(StressField::Rough, 128, random);
  expectThatKeysStandForTriangles(*methodOver(field, 8), *methodOver(field, 8), random);
}

TEST(TeChunkedLod, itsDialIsAScreenErrorByLevels) {
  std::mt19937 random(12);
  const TeLodFieldPtr field = anyField(StressField::Rough, 256, random);
  const auto method = methodOver(field);
  EXPECT_FALSE(method->dial().finerIsLarger);
  TeLodView view = anyView(*field, true, random);
  view.perspective = true;
  view.focal = 665;
  for (const double tau : {0.5, 2.0, 8.0, 32.0}) {
    TeLodAccuracy wanted, dialled;
    wanted.pixelError = tau;
    dialled.dial = tau;
    method->select(view, wanted);
    const std::int64_t triangles = method->selection().triangles;
    method->select(view, dialled);
    EXPECT_EQ(method->selection().dial, tau);
    EXPECT_LE(method->selection().errorBound, tau); // levels' errors are those of the worst chunks
    EXPECT_GE(method->selection().triangles, triangles);
  }
}

TEST(TeChunkedLod, morphingMovesVerticesLittleByLittle) {
  std::mt19937 random(13);
  const TeLodFieldPtr field = hillsToDescendOn(random);
  const auto method = methodOver(field, 8);
  EXPECT_EQ(largestJump(*method, false, 8), 0); // vertices are at their heights; what pops is between them
  const double jump = largestJump(*method, true, 8);
  EXPECT_GT(jump, 0);
  EXPECT_LT(jump, 0.3);
  std::printf("wanted 3 px: vertices move by up to %.3f px a frame\n", jump);
}
