#include "nodes/terrain/TeLevelErrors.h"

#include "generators/base/TeRandom.h"
#include "nodes/gridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

std::vector<float> errorsOf(const TePatchMesh& mesh, int units = 0) {
  TeLevelErrors errors(mesh, std::make_shared<const TeGridLevels>(mesh.columns, mesh.rows));
  bool isDone = false;
  while (!isDone) {
    TeAllowance allowance = units > 0 ? TeAllowance::units(units) : TeAllowance::unlimited();
    isDone = errors.step(allowance);
  }
  return errors.take();
}

/// Height of a level's surface above a sample, by searching all triangles for it.
double surfaceAt(const TePatchMesh& mesh, const std::vector<std::uint32_t>& indices, int x, int y) {
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    double px[3], py[3], pz[3];
    for (std::size_t k = 0; k < 3; ++k) {
      px[k] = indices[i + k] % std::uint32_t(mesh.columns);
      py[k] = indices[i + k] / std::uint32_t(mesh.columns);
      pz[k] = double(mesh.positions[indices[i + k]].z);
    }
    const double area = (px[1] - px[0]) * (py[2] - py[0]) - (px[2] - px[0]) * (py[1] - py[0]);
    const double b = ((x - px[0]) * (py[2] - py[0]) - (px[2] - px[0]) * (y - py[0])) / area;
    const double c = ((px[1] - px[0]) * (y - py[0]) - (x - px[0]) * (py[1] - py[0])) / area;
    if (b >= 0 && c >= 0 && b + c <= 1)
      return pz[0] + b * (pz[1] - pz[0]) + c * (pz[2] - pz[0]);
  }
  ADD_FAILURE() << "no triangle over " << x << ", " << y;
  return 0;
}

} // namespace

TEST(TeLevelErrors, AreTheLargestDeviationOfAnySample) {
  TeRandom random(3, 9, {});
  for (const auto& [columns, rows] :
       {std::pair(31, 31), std::pair(3, 15), std::pair(15, 3), std::pair(9, 20)}) {
    const TePatchMesh mesh =
        gridMesh(*TeLattice::create(65, 1), 0, 0, columns, rows, [&](double x, double y) {
          return float(4 * std::sin(x / 4) * std::cos(y / 3) + random.uniform(-0.5, 0.5));
        });
    const std::vector<float> errors = errorsOf(mesh);
    const TeGridLevels levels(columns, rows);
    ASSERT_EQ(int(errors.size()), levels.count() + 1);
    EXPECT_EQ(errors[0], 0);
    for (int level = 1; level <= levels.count(); ++level) {
      double worst = 0;
      for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
          worst = std::max(worst, std::fabs(surfaceAt(mesh, levels.indices(level), x, y) -
                                            double(mesh.positions[std::size_t(y * columns + x)].z)));
      EXPECT_GE(double(errors[std::size_t(level)]), worst - 1e-9);
      EXPECT_LE(double(errors[std::size_t(level)]), worst * (1 + 1e-6) + 1e-9);
    }
  }
}

TEST(TeLevelErrors, PlanesHaveHardlyAnyAndSpikesTheirHeight) {
  const TeLattice lattice = *TeLattice::create(65, 1);
  for (const float error : errorsOf(
           gridMesh(lattice, 0, 0, 31, 31, [](double x, double y) { return float(0.25 * x + 0.5 * y); })))
    EXPECT_LE(error, 1e-6f);
  TePatchMesh spike = gridMesh(lattice, 0, 0, 31, 31, [](double, double) { return 0.0f; });
  spike.positions[std::size_t(6 * 31 + 6)].z = 100; // on no coarser line
  const std::vector<float> errors = errorsOf(spike);
  for (std::size_t level = 1; level < errors.size(); ++level)
    EXPECT_GE(errors[level], 50) << level;
}

TEST(TeLevelErrors, AnySlicingGivesTheSame) {
  const TePatchMesh mesh = gridMesh(*TeLattice::create(257, 1), 0, 0, 127, 127, [](double x, double y) {
    return float(std::sin(x / 9) * std::cos(y / 5));
  });
  const std::vector<float> whole = errorsOf(mesh);
  EXPECT_EQ(errorsOf(mesh, 1), whole);
  EXPECT_EQ(errorsOf(mesh, 3), whole);
  EXPECT_TRUE(std::is_sorted(whole.begin(), whole.end())) << "for these waves";
}
