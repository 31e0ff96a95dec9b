#include "nodes/lod/TeLodMethod.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace {

/// Needs so many triangles for an error or a dial, and says how it was asked.
class Asked final : public TeLodMethod {
public:
  explicit Asked(bool hasDial) : TeLodMethod(flat()) {
    if (hasDial)
      m_dial = {"samples", true, 2, 100};
  }
  std::string name() const override { return "asked"; }
  const TeLodDial& dial() const override { return m_dial; }
  double bytesPerSample() const override { return 4; }
  void appendPart(std::size_t, TeLodMesh& mesh) const override { mesh.vertices.push_back({}); }

  std::vector<TeLodAccuracy> asked;

protected:
  void choose(const TeLodView&, const TeLodAccuracy& accuracy, TeAllowance&,
              TeLodSelection& selection) override {
    asked.push_back(accuracy);
    const double fineness = accuracy.dial > 0 ? accuracy.dial : 1 / std::max(1e-3, accuracy.pixelError);
    selection.triangles = std::int64_t(100 * fineness);
    selection.parts.push_back({1, selection.triangles});
    selection.parts.push_back({2, 0});
  }

private:
  static TeLodFieldPtr flat() {
    return TeLodField::create(std::make_shared<TeHeightMap>(TeHeightMap::create(3, 3).value()), {}).value();
  }
  TeLodDial m_dial;
};

TeLodAccuracy accuracyOf(double pixels, double dial, std::int64_t most) {
  TeLodAccuracy accuracy;
  accuracy.pixelError = pixels;
  accuracy.dial = dial;
  accuracy.maxTriangles = most;
  return accuracy;
}

} // namespace

TEST(TeLodMethod, LowersTheAccuracyUntilTheBudgetIsKept) {
  Asked method(true);
  method.select({}, accuracyOf(1, 0, 30));
  EXPECT_EQ(method.selection().coarsening, 4);
  EXPECT_EQ(method.selection().triangles, 25);
  EXPECT_EQ(method.selection().parts.size(), 2u) << "of the last one only";
  method.select({}, accuracyOf(1, 8, 300));
  EXPECT_EQ(method.asked.back().dial, 2) << "of a dial that is finer the larger it is";
  method.select({}, accuracyOf(1, 0, 1000));
  EXPECT_EQ(method.selection().coarsening, 1);
}

TEST(TeLodMethod, AnExactSelectionIsLoweredFromA64thOfAPixel) {
  Asked method(false);
  method.select({}, accuracyOf(0, 0, 4000));
  EXPECT_EQ(method.asked.front().pixelError, 0);
  EXPECT_EQ(method.selection().coarsening, 2);
  EXPECT_EQ(method.asked.back().pixelError, 2.0 / 64);
}

TEST(TeLodMethod, DialsAreKeptInRangeAndIgnoredWhereThereIsNone) {
  Asked with(true), without(false);
  with.select({}, accuracyOf(1, 1e9, std::int64_t(1) << 40));
  EXPECT_EQ(with.asked.back().dial, 100);
  without.select({}, accuracyOf(3, 50, 1000));
  EXPECT_EQ(without.asked.back().dial, 0);
  EXPECT_EQ(without.asked.back().pixelError, 3);
  without.select({}, accuracyOf(std::numeric_limits<double>::quiet_NaN(), 0, 1 << 30));
  EXPECT_EQ(without.asked.front().pixelError, 3);
  EXPECT_EQ(without.asked.back().pixelError, 0);
}

TEST(TeLodMethod, GivesUpWhereNothingIsCoarseEnough) {
  Asked method(true);
  method.select({}, accuracyOf(1, 5, 1)); // the dial ends at 2
  EXPECT_GT(method.selection().triangles, 1);
  TeLodMesh mesh;
  method.appendMesh(mesh);
  EXPECT_EQ(mesh.vertices.size(), 2u);
}
