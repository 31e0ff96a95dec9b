// The code of docs/patch-tree.md, compiled and run.

#include "generators/TeGeneratorRegistry.h"
#include "patchdb/TePatchDatabase.h"

#include <gtest/gtest.h>

#include <cstdio>

TEST(PatchTreePage, Queries) {
  //! [queries]
  const TeLattice lattice = TeLattice::create(65, 1.0).value();
  const auto sources =
      std::make_shared<TeSingleSource>(TeGeneratorRegistry::instance().source("noise").value());
  const auto database = std::move(TePatchDatabase::create({lattice, 7, sources}).value());

  const TePatchKey key = tePatchAt(lattice, {1000.0, -250.0}).value();
  if (const auto patch = database->build(key); !patch)
    std::printf("%s\n", patch.error().message.c_str());

  const std::optional<double> height = database->heightAt({1000.0, -250.0});
  const std::optional<TeRayHit> hit = database->intersect({1000.0, -250.0, 5000.0}, {0.0, 0.0, -1.0}, 1e4);
  //! [queries]
  ASSERT_TRUE(height && hit);
  EXPECT_EQ(hit->position.z, *height);
  EXPECT_EQ(hit->key, key);
}
