#include "nodes/lod/LodTest.h"

#include <cstdio>

namespace {

/// Every vertex of the surface is inside of the terrain's box, and, but for morphing, on its sample.
void expectInside(const LodFrame& frame, const TeLodField& field, bool morphs) {
  for (const std::uint32_t index : frame.mesh().indices) {
    const TeLodVertex& vertex = frame.mesh().vertices[index];
    ASSERT_GE(vertex.column, 0);
    ASSERT_GE(vertex.row, 0);
    ASSERT_LE(vertex.column, field.cells());
    ASSERT_LE(vertex.row, field.cells());
    ASSERT_GE(vertex.height, field.lowest());
    ASSERT_LE(vertex.height, field.highest());
    if (!morphs) {
      ASSERT_EQ(vertex.height, field.height(vertex.column, vertex.row));
    }
  }
}

} // namespace

// Boxes that were too low, or one level's instead of all below it, hide terrain at the edge of the picture: a
// narrow camera that sees but the top of a spike, of a cliff or of hills must get what it sees.
LOD_TEST(HardCase, BoundingBoxesLod) {
  constexpr int kCells = 64;
  std::mt19937 random(10);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::int64_t seen = 0, vertices = 0;
  for (const StressField stress :
       {StressField::Rough, StressField::Spike, StressField::Cliff, StressField::Plateau}) {
    const TeLodFieldPtr field = lodField(stressMap(stress, kCells, random));
    const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
    ASSERT_TRUE(method);
    LodFrame frame(field);
    int highColumn = 0, highRow = 0;
    for (int i = 0; i <= kCells * (kCells + 2); i++)
      if (field->height(i % (kCells + 1), i / (kCells + 1)) > field->height(highColumn, highRow)) {
        highColumn = i % (kCells + 1);
        highRow = i / (kCells + 1);
      }
    for (int camera = 0; camera < 60; camera++) {
      SCOPED_TRACE(testing::Message() << "field " << int(stress) << ", camera " << camera);
      const bool top = camera % 2 == 0;
      const glm::dvec3 target =
          top ? field->position(field->vertex(highColumn, highRow))
              : field->position(field->vertex(int(random() % (kCells + 1)), int(random() % (kCells + 1))));
      TeLodView view =
          viewFrom(target + glm::dvec3(uniform(-90, 90), uniform(-90, 90), uniform(0, 60)), 2000);
      // So that it is just inside of the lower edge of the picture.
      const double halfAngle = uniform(0.001, 0.05);
      const glm::dvec3 ahead = target - view.eye;
      lookAlong(view, ahead + glm::dvec3(0, 0, 0.99 * std::tan(halfAngle) * glm::length(ahead)), halfAngle);
      const TeLodAccuracy accuracy = anyAccuracy(random, *method);
      method->select(view, accuracy);
      frame.take(*method);
      expectInside(frame, *field, accuracy.geomorph);
      const TeScreenError::Report report = frame.errors(view);
      ASSERT_EQ(report.uncovered, 0);
      seen += report.samples;
      vertices += std::int64_t(frame.mesh().vertices.size());
    }
  }
  EXPECT_GT(seen, 100);
  std::printf("%s: %lld samples at the edges of narrow pictures, all drawn; %lld vertices inside the box\n",
              name.c_str(), static_cast<long long>(seen), static_cast<long long>(vertices));
}
