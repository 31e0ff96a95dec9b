// LOD methods on large maps: wanted errors hold on the peers' flight, and no camera finds a gap in real
// terrain.

#include "generators/elevation/TeElevationFile.h"
#include "generators/elevation/TeTestFolder.h"
#include "generators/midpoint/TeMidpointDisplacement.h"
#include "nodes/lod/LodTest.h"
#include "nodes/lod/TeFlyover.h"

#include <cstdio>

namespace {

/// As rough as the peers' map: 1025² samples, 10 m apart, midpoint displacement in 65536 steps of 3 cm.
TeLodFieldPtr midpointField() {
  static TeLodFieldPtr field;
  if (field)
    return field;
  TeMidpointParameters parameters;
  parameters.displacement = 500;
  parameters.fall = 0.5;
  TeHeightMap map = TeMidpointDisplacement::create(parameters)
                        .value()
                        ->generate(TeMapRequest::standalone(1025, 1025, 10, 2007).value())
                        .value();
  const TeMapStatistics statistics = map.statistics();
  const float step = (statistics.maximum - statistics.minimum) / 65535;
  for (int row = 0; row < map.height(); row++)
    for (int column = 0; column < map.width(); column++)
      map.at(column, row) = std::round((map.at(column, row) - statistics.minimum) / step);
  TeLodField::Placement placement;
  placement.spacing = 10;
  placement.heightScale = 0.03;
  return field = lodField(std::move(map), placement);
}

/// 1025² samples, 160 m apart, in decimetres; null, with a message, where it cannot be read.
TeLodFieldPtr pugetSound() {
  static TeLodFieldPtr field;
  const std::string path = teTestData("png16/ps_height_1k.png");
  if (field || path.empty())
    return field;
  const auto file = TeElevationFile::open(path);
  if (!file) {
    std::printf("%s\n", file.error().message.c_str());
    return nullptr;
  }
  TeHeightMap map = TeHeightMap::create(1025, 1025).value();
  for (int row = 0; row < 1025; row++)
    for (int column = 0; column < 1025; column++)
      map.at(column, row) = (*file)->post(column, 1024 - row).value();
  TeLodField::Placement placement;
  placement.spacing = 160;
  placement.heightScale = 0.1;
  return field = lodField(std::move(map), placement);
}

TeFlyover flyoverOf(const TeLodField& field) {
  TeFlyover flight;
  flight.cells = field.cells();
  flight.spacing = field.spacing();
  flight.heightScale = field.heightScale();
  flight.sample = [&field](std::int32_t column, std::int32_t row) { return field.height(column, row); };
  return flight;
}

} // namespace

// The causes of overshoot that were seen in others: samples of the border and the last row and column, relief
// that culling did not know of, a depth one level short of all samples, a bound that is none.
LOD_TEST(LodFlight, WantedErrorsHoldOnTheFlyover) {
  const TeLodFieldPtr field = midpointField();
  const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
  ASSERT_TRUE(method);
  const TeFlyover flight = flyoverOf(*field);
  LodFrame frame(field);
  double most = 0, triangles = 0;
  constexpr int kFrames = 12;
  for (int i = 0; i < kFrames; i++) {
    const double wanted[] = {0.5, 2, 8, 32};
    TeLodAccuracy accuracy;
    accuracy.pixelError = wanted[i % 4];
    SCOPED_TRACE(testing::Message() << "frame " << 60 * i << ", " << accuracy.pixelError << " px");
    const TeLodView view = flight.view(60 * i).lodView();
    method->select(view, accuracy);
    frame.take(*method);
    frame.expectRight(view, accuracy);
    if (testing::Test::HasFatalFailure())
      return;
    if (statesBounds(name)) {
      ASSERT_LE(frame.lastWorst, 1.05 * accuracy.pixelError);
    }
    most = std::max(most, frame.lastWorst / accuracy.pixelError);
    triangles += double(method->selection().triangles) / kFrames;
  }
  std::printf("%s: worst error %.3f of the wanted one, %.0f triangles, nothing uncovered\n", name.c_str(),
              most, triangles);
}

LOD_TEST(LodFlight, SpikesOfTheBorderAndOfOddSamplesAreDrawn) {
  constexpr int kCells = 128;
  TeHeightMap map = TeHeightMap::create(kCells + 1, kCells + 1).value();
  const std::pair<int, int> spikes[] = {{0, 0},       {kCells, 0},  {0, kCells}, {kCells, kCells},
                                        {kCells, 63}, {77, kCells}, {1, 1},      {63, 65},
                                        {127, 127},   {127, 3}};
  for (const auto& [column, row] : spikes)
    map.at(column, row) = 3;
  const TeLodFieldPtr field = lodField(std::move(map));
  const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
  ASSERT_TRUE(method);
  LodFrame frame(field);
  for (const glm::dvec3 eye : {glm::dvec3(64, 64, 40), {140, 140, 10}, {-30, 160, 5}, {128, 64, 2}})
    for (const double wanted : {0.1, 1.0, 10.0}) {
      const TeLodView view = viewFrom(eye);
      TeLodAccuracy accuracy;
      accuracy.pixelError = wanted;
      method->select(view, accuracy);
      frame.take(*method);
      frame.expectRight(view, accuracy);
      if (testing::Test::HasFatalFailure())
        return;
    }
}

// A thousand random cameras over real terrain.
LOD_TEST(LodFlight, WatertightOnPugetSound) {
  const TeLodFieldPtr field = pugetSound();
  if (!field)
    GTEST_SKIP() << "no png16/ps_height_1k.png";
  const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
  ASSERT_TRUE(method);
  const bool drawsAll = method->dial().name.empty();
  std::mt19937 random(1000);
  LodFrame frame(field);
  std::int64_t triangles = 0, measured = 0;
  const int cameras = drawsAll ? 30 : 1000;
  for (int camera = 0; camera < cameras; camera++) {
    SCOPED_TRACE(testing::Message() << "camera " << camera);
    const TeLodView view = anyView(random, *field);
    TeLodAccuracy accuracy = anyAccuracy(random, *method);
    accuracy.maxTriangles = 20000; // so that a thousand do not take too long
    method->select(view, accuracy);
    frame.take(*method);
    if (camera % 50 == 0) {
      frame.expectRight(view, accuracy);
      measured++;
    } else {
      ASSERT_EQ(frame.gaps(view), 0);
    }
    if (testing::Test::HasFatalFailure())
      return;
    triangles += method->selection().triangles;
  }
  std::printf("%s: %d cameras, %lld triangles, no gap; %lld measured, none above its bound\n", name.c_str(),
              cameras, static_cast<long long>(triangles), static_cast<long long>(measured));
}
