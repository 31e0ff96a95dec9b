#include "nodes/lod/TeLodMethods.h"
#include "nodes/lod/geomipmap/TeGeoMipMapping.h"
#include "tests/nodes/lod/lodTrials.h"

namespace {

std::unique_ptr<TeLodMethod> methodOver(TeLodFieldPtr field, int patchCells = 0) {
  TeGeoMipMapping::Settings settings;
  settings.patchCells = patchCells;
  return std::move(TeGeoMipMapping::create(std::move(field), settings).value());
}

/// Vertices at one sample that are not at the same height.
int differing(const TeLodField& field, const TeLodMesh& mesh) {
  std::vector<float> heights(std::size_t(field.cells() + 1) * std::size_t(field.cells() + 1), NAN);
  int count = 0;
  for (const std::uint32_t index : mesh.indices) {
    const TeLodVertex& vertex = mesh.vertices[index];
    float& height = heights[std::size_t(vertex.row * (field.cells() + 1) + vertex.column)];
    if (std::isnan(height))
      height = vertex.height;
    count += height != vertex.height;
  }
  return count;
}

} // namespace

TEST(TeGeoMipMapping, neverHasACrack) {
  std::mt19937 random(5);
  int meshes = 0, levels = 0, morphed = 0;
  for (int kind = 0; kind <= int(StressField::Flat); kind++)
    for (const auto& [cells, patchCells] : {std::pair(64, 4), std::pair(64, 16), std::pair(64, 32)}) {
      const TeLodFieldPtr field = anyField(StressField(kind), cells, random);
      const auto method = methodOver(field, patchCells);
      TeWatertight mesh(cells);
      for (int camera = 0; camera < 150; camera++) {
        method->select(anyView(*field, true, random), anyAccuracy(random));
        const TeLodMesh triangles = meshOf(*method);
        mesh.clear();
        addTo(mesh, *field, triangles);
        ASSERT_EQ(differing(*field, triangles), 0) << "field " << kind << " camera " << camera;
        ASSERT_EQ(mesh.cracks(), 0) << "field " << kind << " camera " << camera;
        ASSERT_EQ(mesh.slivers(), 0);
        ASSERT_TRUE(mesh.coversSquare());
        meshes++;
        int widest = 0;
        bool isMorphed = false;
        for (const TeLodPart& part : method->selection().parts) {
          const TeGeoMipPart is = TeGeoMipPart::of(part.key, cells / patchCells);
          for (const int side : is.sides)
            widest = std::max(widest, side - is.level);
          isMorphed = isMorphed || (is.weight > 0 && is.weight < TeGeoMipPart::kWhole);
        }
        levels += widest > 1;
        morphed += isMorphed;
      }
    }
  EXPECT_GT(levels, meshes / 20); // neighbours do differ by more than one level
  EXPECT_GT(morphed, meshes / 20);
  std::printf("%d meshes, %d of them with neighbours more than one level apart, %d morphed: no cracks\n",
              meshes, levels, morphed);
}

TEST(TeGeoMipMapping, itsBoundHolds) {
  std::mt19937 random(6);
  expectThatBoundsHold(
      [](const TeLodFieldPtr& field) { return methodOver(field, field->cells() == 64 ? 32 : 8); }, random);
}

TEST(TeGeoMipMapping, noErrorMeansEverySample) {
  std::mt19937 random(7);
  const TeLodFieldPtr field = anyField(StressField::Plateau, 64, random);
  const auto method = methodOver(field);
  TeLodAccuracy exact;
  exact.pixelError = 0;
  method->select(anyView(*field, true, random), exact);
  EXPECT_EQ(method->selection().triangles, 2 * 64 * 64);
  EXPECT_EQ(method->selection().errorBound, 0);
}

// From the smallest terrain on.
TEST(TeGeoMipMapping, takesAnySize) {
  std::mt19937 random(8);
  for (int cells = 2; cells <= 256; cells *= 2) {
    const TeLodFieldPtr field = anyField(StressField::Rough, cells, random);
    const auto method = TeLodMethods::create("geomipmap", field);
    ASSERT_TRUE(method);
    EXPECT_EQ((*method)->name(), "geomipmap");
    for (int camera = 0; camera < 5; camera++) {
      const TeLodView view = anyView(*field, true, random);
      (*method)->select(view, anyAccuracy(random));
      TeWatertight mesh(cells);
      addTo(mesh, *field, meshOf(**method));
      EXPECT_EQ(mesh.cracks(), 0);
      EXPECT_TRUE(mesh.coversSquare());
    }
  }
}

TEST(TeGeoMipMapping, refusesOtherPatches) {
  std::mt19937 random(9);
  const TeLodFieldPtr field = anyField(StressField::Flat, 64, random);
  for (const int cells : {-8, 1, 12, 256}) {
    TeGeoMipMapping::Settings settings;
    settings.patchCells = cells;
    const auto method = TeGeoMipMapping::create(field, settings);
    ASSERT_FALSE(method);
    EXPECT_NE(method.error().message.find(std::to_string(cells)), std::string::npos);
  }
}

TEST(TeGeoMipMapping, lowersTheAccuracyForABudget) {
  std::mt19937 random(10);
  const TeLodFieldPtr field = anyField(StressField::Rough, 256, random);
  const auto method = methodOver(field, 16);
  expectThatABudgetIsKept(*method);
  EXPECT_EQ(method->selection().triangles, 2 * 16 * 16) << "as coarse as can be, if even that is too much";
}

TEST(TeGeoMipMapping, keysStandForTriangles) {
  std::mt19937 random(11);
  const TeLodFieldPtr field = anyField(StressField::Rough, 128, random);
  expectThatKeysStandForTriangles(*methodOver(field, 8), *methodOver(field, 8), random);
}

TEST(TeGeoMipMapping, itsDialIsAThresholdInPixels) {
  std::mt19937 random(12);
  const TeLodFieldPtr field = anyField(StressField::Rough, 256, random);
  const auto method = methodOver(field, 8);
  EXPECT_FALSE(method->dial().finerIsLarger);
  TeLodView view = anyView(*field, true, random);
  view.perspective = true;
  view.focal = 665;
  std::int64_t before = std::numeric_limits<std::int64_t>::max();
  for (const double threshold : {0.01, 1.0, 4.0, 16.0, 1e6}) {
    TeLodAccuracy accuracy;
    accuracy.dial = threshold;
    method->select(view, accuracy);
    EXPECT_EQ(method->selection().dial, threshold);
    EXPECT_LE(method->selection().triangles, before);
    before = method->selection().triangles;
  }
  EXPECT_EQ(before, 2 * 32 * 32);
}

// Not as little by little as where parts have no neighbours: when one changes its level, what the strip
// beside it asks of a weight changes at once. But never by more than is wanted.
TEST(TeGeoMipMapping, morphingMovesVerticesWithinTheWantedError) {
  std::mt19937 random(13);
  const TeLodFieldPtr field = hillsToDescendOn(random);
  const auto method = methodOver(field, 8);
  EXPECT_EQ(largestJump(*method, false, 1), 0); // vertices are at their heights; what pops is between them
  const double jump = largestJump(*method, true, 1);
  EXPECT_GT(jump, 0);
  EXPECT_LE(jump, 3);
  std::printf("wanted 3 px: vertices move by up to %.3f px a frame\n", jump);
}
