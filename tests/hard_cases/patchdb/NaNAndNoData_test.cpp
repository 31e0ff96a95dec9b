#include "generators/base/TeRandom.h"
#include "patchdb/TeMeshCensus.h"
#include "patchdb/TeTestWorlds.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

// NaN and infinities wherever a source puts them, from single samples to whole maps: never in a mesh, never
// in an answer; what is drawn is what can be asked for.
TEST(HardCase, NaNAndNoDataPatchdb) {
  long holes = 0;
  long drawn = 0;
  for (std::uint64_t share : {1, 5, 50, 95, 100})
    for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                      -std::numeric_limits<float>::infinity()}) {
      const auto function = [=](std::int64_t x, std::int64_t y) {
        const std::uint64_t bits = teHashCombine(std::uint64_t(x), std::uint64_t(y) + share);
        return bits % 100 < share ? bad : float(bits >> 48);
      };
      // Fitting, so that heights are copied, and mixed with holes of other maps, so that they are blended.
      const auto fitting = std::make_shared<TeSampleSource>(function);
      const auto mixed = std::make_shared<TeChequeredSources>(
          std::vector<TeHeightSourcePtr>{fitting, std::make_shared<TeHashSource>()});
      for (const std::shared_ptr<const TeSourceChooser>& sources :
           {std::shared_ptr<const TeSourceChooser>(std::make_shared<TeSingleSource>(fitting)),
            std::shared_ptr<const TeSourceChooser>(mixed)}) {
        auto database = teTestDatabase(sources, 17);
        for (int y = 0; y < 2; ++y)
          for (int x = 0; x < 2; ++x)
            ASSERT_TRUE(database->build({x, y, 0}));
        TeMeshCensus census;
        for (const TePatchMesh& mesh : teBlockMeshes(*database, {0, 0, 0}, 2, 2)) {
          ASSERT_TRUE(census.add(mesh));
          for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            ASSERT_TRUE(std::isfinite(mesh.positions[v].z));
            ASSERT_NEAR(glm::dot(glm::dvec3(mesh.normals[v]), glm::dvec3(mesh.normals[v])), 1, 1e-6);
          }
        }
        const TeLattice& lattice = database->lattice();
        long complete = 0;
        for (int y = 1; y < 15; ++y)
          for (int x = 1; x < 15; ++x) {
            const glm::dvec2 middle(0.5 * (lattice.position(x) + lattice.position(x + 1)),
                                    0.5 * (lattice.position(y) + lattice.position(y + 1)));
            const auto height = database->heightAt(middle);
            ASSERT_TRUE(!height || std::isfinite(*height));
            const auto down = database->intersect({middle, 1e6}, {1e-3, 0, -1e6}, 2);
            ASSERT_EQ(down.has_value(), height.has_value());
            complete += height ? 1 : 0;
          }
        ASSERT_EQ(long(census.triangles().size()), 2 * complete);
        drawn += complete;
        holes += 14 * 14 - complete;
      }
    }
  std::printf("NaNAndNoDataPatchdb: %ld cells drawn, %ld left out, no NaN in any array or answer\n", drawn,
              holes);
}
