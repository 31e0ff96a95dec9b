#include "nodes/lod/roam/TeRoamScreen.h"

#include "nodes/lod/roam/RoamWorld.h"

#include <limits>

namespace {

constexpr int kCells = 64;

struct Boxes {
  TeRoamBoxes boxes;
  void add(float x, float y, float size, float low, float high, float error) {
    const std::size_t last = boxes.x.size();
    boxes.resize(last + 1);
    boxes.x[last] = x;
    boxes.y[last] = y;
    boxes.size[last] = size;
    boxes.low[last] = low;
    boxes.high[last] = high;
    boxes.error[last] = error;
  }
  std::vector<float> priorities(const TeLodField& field, const TeLodView& view) const {
    std::vector<float> result(boxes.x.size());
    TeRoamScreen(field, view, 0).priorities(boxes, 0, result.size(), result.data());
    return result;
  }
};

/// Boxes of lattice squares with any heights, each followed by one within it.
Boxes nestedBoxes(std::mt19937& random, int count) {
  Boxes made;
  for (int i = 0; i < count; i++) {
    const int log = 1 + int(random() % 6), size = 1 << log;
    const int x = int(random() % std::uint32_t(kCells / size)) * size;
    const int y = int(random() % std::uint32_t(kCells / size)) * size;
    const float low = float(random() % 100) - 50, high = low + float(random() % 40),
                error = float(random() % 30);
    made.add(float(x), float(y), float(size), low, high, error);
    made.add(float(x + size / 2 * int(random() % 2)), float(y + size / 2 * int(random() % 2)),
             float(size / 2), low + (high - low) / 4, high, random() % 2 ? error : error / 2);
  }
  return made;
}

TeLodFieldPtr placedTerrain(std::mt19937& random) {
  TeLodField::Placement placement;
  placement.corner = {1000, -5000, 20};
  placement.spacing = 3;
  placement.heightScale = 0.5;
  return TeLodField::create(
             std::make_shared<const TeHeightMap>(stressMap(StressField::Rough, kCells, random)), placement)
      .value();
}

double distanceToBox(const glm::dvec3& eye, const glm::dvec3& low, const glm::dvec3& high) {
  return glm::distance(eye, glm::clamp(eye, low, high));
}

} // namespace

TEST(TeRoamScreen, isTheErrorAtTheDistanceToTheBoxRoundedUp) {
  std::mt19937 random(11);
  const TeLodFieldPtr field = placedTerrain(random);
  const Boxes made = nestedBoxes(random, 50);
  int seen = 0, culled = 0;
  for (int camera = 0; camera < 500; camera++) {
    TeLodView view = anyView(*field, random);
    view.eye += field->placement().corner;
    for (int i = 0; i < view.planeCount; i++)
      view.planes[std::size_t(i)].w -=
          glm::dot(glm::dvec3(view.planes[std::size_t(i)]), field->placement().corner);
    const std::vector<float> priorities = made.priorities(*field, view);
    for (std::size_t i = 0; i < priorities.size(); i++) {
      const TeRoamBoxes& b = made.boxes;
      const glm::dvec3 low = field->position(double(b.x[i]), double(b.y[i]), double(b.low[i]));
      const glm::dvec3 high = field->position(double(b.x[i]) + double(b.size[i]),
                                              double(b.y[i]) + double(b.size[i]), double(b.high[i]));
      if (priorities[i] < 0) {
        culled++;
        ASSERT_FALSE(view.meets(low, high));
        continue;
      }
      const double distance = std::max(0.0, distanceToBox(view.eye, low, high) - view.slack);
      const double pixels = view.pixels(double(b.error[i]) * field->heightScale(), distance);
      if (pixels > double(std::numeric_limits<float>::max())) {
        ASSERT_EQ(priorities[i], std::numeric_limits<float>::max());
        continue;
      }
      seen++;
      ASSERT_GE(double(priorities[i]), pixels);
      if (distance > 1e-3 || !view.perspective) {
        ASSERT_LE(double(priorities[i]), pixels * (1 + 1e-6));
      }
    }
  }
  EXPECT_GT(seen, 10000);
  EXPECT_GT(culled, 1000);
}

TEST(TeRoamScreen, neverRisesFromABoxToOneWithin) {
  std::mt19937 random(12);
  const TeLodFieldPtr field = stressTerrain(StressField::Rough, kCells, random);
  const Boxes made = nestedBoxes(random, 100);
  for (int camera = 0; camera < 1000; camera++) {
    const std::vector<float> priorities = made.priorities(*field, anyView(*field, random));
    for (std::size_t i = 0; i < priorities.size(); i += 2)
      ASSERT_LE(priorities[i + 1], priorities[i]) << camera << " " << i;
  }
}

TEST(TeRoamScreen, hasTheSameBitsForAnyNumberAtATime) {
  std::mt19937 random(13);
  const TeLodFieldPtr field = stressTerrain(StressField::Rough, kCells, random);
  const Boxes made = nestedBoxes(random, 21);
  const TeRoamScreen screen(*field, anyView(*field, random), 0);
  std::vector<float> whole(made.boxes.x.size());
  screen.priorities(made.boxes, 0, whole.size(), whole.data());
  for (std::size_t first = 0; first < whole.size(); first++)
    for (const std::size_t count : {std::size_t(1), std::min<std::size_t>(5, whole.size() - first)}) {
      std::vector<float> part(count);
      screen.priorities(made.boxes, first, count, part.data());
      for (std::size_t i = 0; i < count; i++)
        ASSERT_EQ(part[i], whole[first + i]);
    }
}

TEST(TeRoamScreen, freePlacesAreNotInView) {
  std::mt19937 random(14);
  const TeLodFieldPtr field = stressTerrain(StressField::Flat, kCells, random);
  Boxes made;
  made.add(0, 0, 64, 7, 7, 0);
  made.add(0, 0, 64, 7, 7, -1);
  const std::vector<float> priorities = made.priorities(*field, viewFrom({10, 10, 7}));
  EXPECT_EQ(priorities[0], 0); // in the flat box, and no error
  EXPECT_EQ(priorities[1], -1);
}
