#include "nodes/lod/lodNode.h"
#include "render/TeSeamlessNodeTest.h"
#include "render/magenta.h"

#include <cmath>
#include <cstdio>
#include <optional>

namespace {

constexpr int kFrames = 1000;
constexpr int kSide = 64;
constexpr float kTremble = 0.3f; ///< metres; the eye is held within 8 m
constexpr double kFieldOfView = 1.6;
constexpr double kPixels = 0.4;

SbVec3f trembling(float height, int frame) {
  const float angle = float(frame) * 2.39996f;
  return SbVec3f(10, -50, height) + SbVec3f(std::cos(angle), std::sin(angle), std::sin(3 * angle)) * kTremble;
}

/// Chooses for eyes over the middle without holding them.
class Unheld {
public:
  explicit Unheld(const std::string& method) {
    TeLodField::Placement placement;
    placement.corner = {-512, -512, 0};
    placement.spacing = 1024.0 / kSide;
    m_field = *TeLodField::create(std::make_shared<const TeHeightMap>(hillsMap(kSide)), placement);
    m_method = std::move(TeLodMethods::create(method, m_field).value());
  }
  std::int64_t chosen(const SbVec3f& eye) {
    TeLodView view;
    view.eye = {eye[0], eye[1], eye[2]};
    view.focal = 36 / 2.0 / std::tan(kFieldOfView / 2);
    TeLodAccuracy accuracy;
    accuracy.pixelError = kPixels;
    m_method->select(view, accuracy);
    return m_method->selection().triangles;
  }
  /// A height where one more or less of it changes what is needed.
  std::optional<float> edge() {
    std::int64_t before = chosen(trembling(700, 0));
    for (float height = 700; height < 4000; height += 1) {
      const std::int64_t now = chosen(trembling(height + 1, 0));
      if (now != before)
        return height + 0.5f;
      before = now;
    }
    return {};
  }
  int switches(float height) {
    int count = 0;
    std::int64_t before = chosen(trembling(height, 0));
    for (int i = 1; i < kFrames; i++) {
      const std::int64_t now = chosen(trembling(height, i));
      count += now != before;
      before = now;
    }
    return count;
  }

private:
  TeLodFieldPtr m_field;
  std::unique_ptr<TeLodMethod> m_method;
};

class LodThrash : public TeSeamlessNodeTest, public testing::WithParamInterface<std::string> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(HardCase, LodThrash, testing::ValuesIn(TeLodMethods::names()), [](const auto& info) {
  std::string name = info.param;
  for (char& letter : name)
    letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
  return name;
});

// A camera that trembles where the least move changes what is needed: the triangles stay the same, since the
// eye is held. No pixel within the terrain is empty, and the error that is stated stays within what is
// wanted.
TEST_P(LodThrash, ATremblingCameraSwitchesNothing) {
  Unheld free(GetParam());
  const std::optional<float> edge = free.edge();
  const float height = edge.value_or(900);
  const auto node = lodNode(GetParam(), kSide, 1024);
  node->pixelError = float(kPixels);
  const auto scene = seenBy(SbVec3f(0, 0, 0), SbVec3f(0, 1, 0), node.get());
  addSun(scene.get());
  auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
  camera->orientation.setValue(SbVec3f(1, 0, 0), 0); // straight down, all of the terrain in view
  camera->heightAngle = float(kFieldOfView);
  auto renderer = TeSceneRenderer::create(context(), 48, 36);
  ASSERT_TRUE(renderer);
  int switches = 0, empty = 0;
  std::int64_t before = 0, uploaded = 0;
  double largestBound = 0;
  for (int i = 0; i < kFrames; i++) {
    camera->position = trembling(height, i);
    if (i % 10 == 0)
      empty += enclosedBackground(frame(**renderer, scene.get()));
    else
      ASSERT_TRUE((*renderer)->draw(scene.get()));
    const TeLodStatistics& statistics = node->statistics();
    switches += i > 0 && statistics.triangles != before;
    uploaded += i > 2 ? statistics.bytesUploaded : 0;
    before = statistics.triangles;
    largestBound = std::max(largestBound, statistics.errorBound);
  }
  EXPECT_LE(switches, 1);
  EXPECT_EQ(empty, 0);
  EXPECT_EQ(uploaded, 0);
  if (lodTellsBound(GetParam())) {
    EXPECT_LE(largestBound, kPixels);
  }
  std::printf("%s: %d frames, trembling by %g m: %d switches (without holding the eye %d), bound up to %.3f "
              "px\n",
              GetParam().c_str(), kFrames, double(kTremble), switches, edge ? free.switches(height) : 0,
              largestBound);
}
