#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

namespace {

struct Tried {
  std::int64_t meshes = 0;
  std::int64_t triangles = 0;
  std::int64_t limited = 0;
};

/// Any way of drawing from any eye.
void tryCamera(std::mt19937& random, const TeSeamlessSelector& selector, const TeSeamlessParts& parts,
               Tried& tried) {
  const TeSeamlessLayout& layout = selector.layout();
  const double relief = std::max(1.0f, selector.bounds()->range(0, 0, 0).high);
  TeSeamlessPlacement placement;
  // At spacing 1 eyes on the lattice and next to it stay there: rounding must not decide what fits.
  if (random() % 2) {
    placement.corner = {double(random() % 1000), -double(random() % 1000), 0};
    placement.spacing = std::exp(double(random() % 100) / 25 - 2);
  }
  TeSeamlessAccuracy accuracy;
  accuracy.precision = random() % 4 == 0 ? 1 : 1 + double(random() % 1000) / 200;
  accuracy.geomorph = random() % 2;
  if (random() % 2)
    accuracy.pixelError = std::exp(double(random() % 100) / 15 - 2);
  accuracy.exact = random() % 50 == 0;
  const double focals[] = {665.1, 5, 1e5, 3e7};
  TeLodView view =
      viewFrom(anyEye(random, layout.resolution() * placement.spacing, relief), focals[random() % 4]);
  view.eye += placement.corner;
  view.perspective = random() % 10 != 0;
  view.slack = random() % 4 ? 0 : placement.spacing;
  const TeClipResidency residency =
      anyResidency(random, layout, 4, glm::dvec2(view.eye - placement.corner) / placement.spacing);
  const bool limited = random() % 3 == 0;

  TeSeamlessSelection selection;
  selector.select(view, placement, accuracy, limited ? &residency : nullptr, selection);
  TeWatertight mesh(layout.resolution());
  meshOf(selection, layout, parts, mesh);
  ASSERT_EQ(mesh.cracks(), 0);
  ASSERT_EQ(mesh.slivers(), 0);
  ASSERT_TRUE(mesh.coversSquare());
  tried.meshes++;
  tried.triangles += selection.triangles;
  tried.limited += limited;
}

} // namespace

TEST(HardCase, NoTJunctionsSeamless) {
  std::mt19937 random(4);
  Tried tried;
  const int sizes[][3] = {{64, 2, 2}, {128, 4, 2}, {64, 2, 3}, {64, 4, 3}, {128, 4, 4}, {32, 8, 2}};
  for (int field = 0; field <= int(StressField::Flat); field++)
    for (const auto& size : sizes) {
      const auto layout = TeSeamlessLayout::create(size[0], size[1], size[2]).value();
      const TeSeamlessSelector selector(
          layout, TeSeamlessBounds::create(layout, stressMap(StressField(field), size[0], random)).value());
      const TeSeamlessParts parts(layout);
      for (int camera = 0; camera < 280; camera++) {
        SCOPED_TRACE(testing::Message() << "field " << field << " resolution " << size[0] << " minimum "
                                        << size[1] << " levels " << size[2] << " camera " << camera);
        tryCamera(random, selector, parts, tried);
        if (HasFatalFailure())
          return;
      }
    }
  std::printf("%lld cameras, %lld of them with limited heights, %lld triangles: every edge inside is shared "
              "by two, none is missing\n",
              static_cast<long long>(tried.meshes), static_cast<long long>(tried.limited),
              static_cast<long long>(tried.triangles));
  EXPECT_GE(tried.meshes, 10000);
}
