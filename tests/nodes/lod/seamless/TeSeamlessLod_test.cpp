#include "nodes/lod/seamless/TeSeamlessLod.h"

#include "nodes/lod/lodTrials.h"

#include <map>

namespace {

std::unique_ptr<TeLodMethod> methodOver(const TeLodFieldPtr& field) {
  return std::move(TeSeamlessLod::create(field)).value();
}

bool isSame(const TeLodMesh& a, const TeLodMesh& b) {
  const auto same = [](const TeLodVertex& p, const TeLodVertex& q) {
    return p.column == q.column && p.row == q.row && p.height == q.height;
  };
  return a.indices == b.indices && a.vertices.size() == b.vertices.size() &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), same);
}

} // namespace

TEST(TeSeamlessLod, ChoosesWhatTheSelectorChooses) {
  std::mt19937 random(6);
  const TeLodFieldPtr field = anyField(StressField::Rough, 128, random);
  const auto method = methodOver(field);
  const auto& selector = static_cast<const TeSeamlessLod&>(*method).selector();
  TeSeamlessPlacement placement;
  placement.corner = field->placement().corner;
  placement.spacing = field->spacing();
  placement.heightScale = field->heightScale();
  for (int trial = 0; trial < 40; trial++) {
    const TeLodView view = anyView(*field, false, random);
    TeLodAccuracy accuracy;
    accuracy.pixelError = 2;
    accuracy.dial = trial % 2 ? 3 : 0;
    method->select(view, accuracy);
    TeSeamlessAccuracy wanted;
    wanted.pixelError = trial % 2 ? 0 : 2;
    wanted.precision = 3;
    TeSeamlessSelection selection;
    selector.select(view, placement, wanted, nullptr, selection);
    EXPECT_EQ(method->selection().triangles, selection.triangles);
    EXPECT_EQ(method->selection().errorBound, selection.errorBound);
    std::int64_t triangles = 0;
    for (const TeLodPart& part : method->selection().parts)
      triangles += part.triangles;
    EXPECT_EQ(triangles, selection.triangles);
  }
}

TEST(TeSeamlessLod, PartsWithTheSameKeyAreTheSame) {
  std::mt19937 random(7);
  const TeLodFieldPtr field = anyField(StressField::Rough, 128, random);
  const auto method = methodOver(field);
  std::map<std::uint64_t, TeLodMesh> known;
  int again = 0;
  for (int trial = 0; trial < 60; trial++) {
    TeLodAccuracy accuracy;
    accuracy.pixelError = 1 + trial % 5;
    accuracy.geomorph = trial % 3 == 0;
    method->select(anyView(*field, false, random), accuracy);
    for (std::size_t part = 0; part < method->selection().parts.size(); part++) {
      TeLodMesh mesh;
      method->appendPart(part, mesh);
      const auto [found, isNew] = known.try_emplace(method->selection().parts[part].key, mesh);
      again += !isNew;
      ASSERT_TRUE(isSame(found->second, mesh));
    }
  }
  EXPECT_GT(again, 20);
}

TEST(TeSeamlessLod, SettingsThatDoNotFitAreAnError) {
  std::mt19937 random(8);
  TeSeamlessLod::Settings settings;
  settings.levels = 1;
  EXPECT_FALSE(TeSeamlessLod::create(anyField(StressField::Rough, 32, random), settings));
  EXPECT_TRUE(TeSeamlessLod::create(anyField(StressField::Rough, 2, random)));
}
