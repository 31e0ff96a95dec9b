// What every LOD method keeps to (TeLodMethod), over random cameras and fields that have broken such methods.

#include "nodes/lod/LodTest.h"

#include "nodes/lod/TePerspectiveView.h"

#include <cstdio>
#include <map>
#include <set>
#include <vector>

TEST(TeLodMethods, NamesAreUniqueAndMadeByName) {
  const TeLodFieldPtr field = lodField(TeHeightMap::create(5, 5).value());
  std::set<std::string> names;
  for (const std::string& name : TeLodMethods::names()) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(lodMethod(name, field)->name(), name);
  }
  EXPECT_EQ(TeLodMethods::names().front(), "brute");
  const auto none = TeLodMethods::create("none", field);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("brute"), std::string::npos) << none.error().message;
}

// For a true camera within the slack of the one that was told, too.
LOD_TEST(LodMethod, BoundHolds) {
  std::mt19937 random(20);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int frames = 0;
  double ratios = 0;
  for (int stress = 0; stress <= int(StressField::Flat); stress++) {
    TeLodField::Placement placement;
    placement.corner = {uniform(-1e4, 1e4), uniform(-1e4, 1e4), uniform(-100, 100)};
    placement.spacing = uniform(0.5, 20);
    placement.heightScale = uniform(0.01, 2);
    const TeLodFieldPtr field = lodField(stressMap(StressField(stress), 128, random), placement);
    const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
    ASSERT_TRUE(method);
    LodFrame frame(field);
    for (int trial = 0; trial < 50; trial++) {
      TeLodView told = anyView(random, *field);
      TeLodView view = told;
      if (random() % 2) {
        told.slack = uniform(0, 5) * placement.spacing;
        view.eye += told.slack * glm::normalize(glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
        for (int i = 0; i < view.planeCount; i++) // which are those of the true eye
          told.planes[std::size_t(i)].w = view.planes[std::size_t(i)].w =
              -glm::dot(glm::dvec3(view.planes[std::size_t(i)]), view.eye);
      }
      const TeLodAccuracy accuracy = anyAccuracy(random, *method);
      SCOPED_TRACE(testing::Message()
                   << "field " << stress << ", trial " << trial << ", slack " << told.slack << ", geomorph "
                   << accuracy.geomorph << ", planes " << told.planeCount);
      method->select(told, accuracy);
      frame.take(*method);
      frame.expectRight(told, view, accuracy);
      if (testing::Test::HasFatalFailure())
        return;
      const double bound = method->selection().errorBound;
      if (bound > 0 && std::isfinite(bound)) {
        ratios += frame.lastWorst / bound;
        frames++;
      }
    }
  }
  std::printf("%s: true error on average %.2f of the bound (%d frames)\n", name.c_str(),
              ratios / std::max(1, frames), frames);
}

LOD_TEST(LodMethod, AtZeroPixelsItIsTheFullSurface) {
  std::mt19937 random(1);
  TeLodView all; // measures in metres
  all.perspective = false;
  for (int stress = 0; stress <= int(StressField::Flat); stress++)
    for (const int cells : {2, 16, 128}) {
      SCOPED_TRACE(testing::Message() << "field " << stress << ", " << cells << " cells");
      const TeLodFieldPtr field = lodField(stressMap(StressField(stress), cells, random));
      const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
      ASSERT_TRUE(method);
      TeLodAccuracy accuracy;
      accuracy.pixelError = 0;
      method->select(viewFrom({0.4 * cells, -3.0 * cells, 20}), accuracy);
      EXPECT_EQ(method->selection().errorBound, 0);
      LodFrame frame(field);
      frame.take(*method);
      const TeScreenError::Report report = frame.errors(all);
      EXPECT_EQ(report.samples, (cells + 1) * (cells + 1));
      EXPECT_EQ(report.uncovered, 0);
      EXPECT_EQ(report.worstMetres, 0);
      EXPECT_EQ(frame.gaps(all), 0);
    }
}

// The dial ranges from coarse to fine, and what it comes to is measured as any other accuracy.
LOD_TEST(LodMethod, TheDialMakesItFiner) {
  std::mt19937 random(3);
  const TeLodFieldPtr field = lodField(stressMap(StressField::Rough, 128, random));
  const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
  ASSERT_TRUE(method);
  const TeLodDial& dial = method->dial();
  if (dial.name.empty())
    return;
  ASSERT_GT(dial.least, 0);
  ASSERT_GT(dial.most, dial.least);
  const TeLodView view = viewFrom({64, -40, 60});
  LodFrame frame(field);
  TeLodAccuracy accuracy;
  std::int64_t before = 0, first = 0;
  constexpr int kSteps = 12;
  for (int step = 0; step <= kSteps; step++) {
    const double share = double(dial.finerIsLarger ? step : kSteps - step) / kSteps;
    accuracy.dial = dial.least * std::pow(dial.most / dial.least, share);
    SCOPED_TRACE(testing::Message() << dial.name << " " << accuracy.dial);
    method->select(view, accuracy);
    const TeLodSelection& selection = method->selection();
    EXPECT_NEAR(selection.dial, accuracy.dial, 1e-6 * accuracy.dial);
    frame.take(*method);
    frame.expectRight(view, accuracy);
    if (testing::Test::HasFatalFailure())
      return;
    EXPECT_GE(selection.triangles, before);
    before = selection.triangles;
    if (step == 0)
      first = selection.triangles;
  }
  EXPECT_GT(before, first);
}

// What is made of a part may be kept: a key means the same triangles for good.
LOD_TEST(LodMethod, EqualKeysAreEqualTriangles) {
  std::mt19937 random(5);
  const TeLodFieldPtr field = lodField(stressMap(StressField::Rough, 128, random));
  const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
  ASSERT_TRUE(method);
  std::map<std::uint64_t, std::string> known;
  int met = 0;
  for (int frame = 0; frame < 40; frame++) {
    TeLodView view = viewFrom({64 + 2.0 * (frame % 20), 20, 30});
    lookAlong(view, {0.3, 1, -0.5}, 0.6);
    TeLodAccuracy accuracy;
    accuracy.pixelError = frame < 20 ? 4 : 10;
    accuracy.geomorph = method->morphs() && frame % 4 == 3;
    method->select(view, accuracy);
    std::set<std::uint64_t> keys;
    for (std::size_t part = 0; part < method->selection().parts.size(); part++) {
      TeLodMesh mesh;
      method->appendPart(part, mesh);
      ASSERT_EQ(mesh.triangles(), method->selection().parts[part].triangles);
      std::string bytes(reinterpret_cast<const char*>(mesh.vertices.data()),
                        mesh.vertices.size() * sizeof(TeLodVertex));
      for (const std::vector<std::uint32_t>* indices : {&mesh.indices, &mesh.skirts})
        bytes.append(reinterpret_cast<const char*>(indices->data()), indices->size() * sizeof(std::uint32_t));
      const std::uint64_t key = method->selection().parts[part].key;
      EXPECT_TRUE(keys.insert(key).second) << "two parts of a frame with one key";
      const auto [found, isNew] = known.try_emplace(key, bytes);
      met += !isNew;
      ASSERT_EQ(found->second, bytes) << "frame " << frame << ", key " << key;
    }
  }
  std::printf("%s: %zu keys, %d met again\n", name.c_str(), known.size(), met);
}
