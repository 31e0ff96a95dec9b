#include "nodes/lod/LodTest.h"
#include "nodes/lod/TePerspectiveView.h"

#include <cstdio>

namespace {

constexpr int kCells = 256;
/// Of 131,072; enough for patches of all samples around an eye that is inside of their boxes.
constexpr std::int64_t kBudget = 40000;

} // namespace

// Fields of view from 0.001° to 179°, parallel views, a viewport of one pixel, from anywhere: triangles keep
// within the budget, the bound is a number, and all in view is drawn.
LOD_TEST(HardCase, ExtremeViewsLod) {
  std::mt19937 random(19);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::int64_t views = 0, most = 0, lowered = 0;
  for (const StressField stress : {StressField::Rough, StressField::Checkerboard}) {
    const TeLodFieldPtr field = lodField(stressMap(stress, kCells, random));
    const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
    ASSERT_TRUE(method);
    const bool drawsAll = method->dial().name.empty();
    LodFrame frame(field);
    for (const double degrees : {0.001, 1.0, 60.0, 170.0, 179.0, 0.0})
      for (const int pixels : {1, 768, 16384})
        for (const double wanted : {0.0, 0.5, 50.0}) {
          TePerspectiveView camera;
          camera.eye = anyEye(random, kCells, 30);
          camera.forward = glm::normalize(glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 0.2)));
          camera.width = camera.height = pixels;
          camera.nearDistance = 1e-3;
          camera.fieldOfView = (degrees > 0 ? degrees : 90) * 3.14159265358979 / 180;
          TeLodView view = camera.lodView();
          view.perspective = degrees > 0;
          if (!view.perspective) {
            view.planeCount = 0;
            view.focal = pixels / 100.0;
          }
          TeLodAccuracy accuracy;
          accuracy.pixelError = wanted;
          accuracy.maxTriangles = kBudget;
          SCOPED_TRACE(testing::Message() << degrees << "°, " << pixels << " pixels, wanted " << wanted
                                          << ", field " << int(stress));
          method->select(view, accuracy);
          const TeLodSelection& selection = method->selection();
          ASSERT_LE(selection.triangles, drawsAll ? 2 * kCells * kCells : kBudget);
          ASSERT_FALSE(std::isnan(selection.errorBound));
          frame.take(*method);
          frame.expectRight(view, accuracy);
          if (testing::Test::HasFatalFailure())
            return;
          views++;
          lowered += selection.coarsening > 1;
          most = std::max(most, selection.triangles);
        }
  }
  std::printf("%s: %lld views, at most %lld triangles of %lld; accuracy lowered in %lld\n", name.c_str(),
              static_cast<long long>(views), static_cast<long long>(most), static_cast<long long>(kBudget),
              static_cast<long long>(lowered));
}
