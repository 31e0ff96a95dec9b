#include "patchdb/TePatchJob.h"

#include "generators/base/TeRandom.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <numeric>

namespace {

bool sameBits(const TeHeightMap& a, const TeHeightMap& b) {
  return a.width() == b.width() && std::memcmp(a.data(), b.data(), a.bytes()) == 0;
}

} // namespace

// Two neighbours on each side of a patch, made in every order and interleaved by slices of many lengths: all
// runs give the same patches, and the common rows are the same memory.
TEST(HardCase, SharedBorder) {
  const int n = 8;
  const std::array<TePatchKey, 5> keys = {TePatchKey{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  const auto sources = std::make_shared<TeChequeredSources>(std::vector<TeHeightSourcePtr>{
      std::make_shared<TeHashSource>(1), std::make_shared<TeHashSource>(2, 3000.0f)});
  std::array<int, 5> order;
  std::iota(order.begin(), order.end(), 0);
  std::unique_ptr<TePatchDatabase> reference;
  int runs = 0;
  int rows = 0;
  do {
    for (int units : {1, 3, 17, 100000}) {
      auto database = teTestDatabase(sources, 2 * n + 1);
      std::vector<std::unique_ptr<TePatchJob>> jobs;
      for (int i : order)
        jobs.push_back(std::make_unique<TePatchJob>(*database, keys[std::size_t(i)]));
      bool working = true;
      while (working) {
        working = false;
        for (auto& job : jobs) {
          TeAllowance allowance = TeAllowance::units(units);
          working = job->step(allowance) == TeProgress::Working || working;
        }
      }
      for (auto& job : jobs)
        ASSERT_EQ(job->progress(), TeProgress::Done) << job->error().message;
      const TeHeightMap& middle = database->find(keys[0])->heights();
      const TeHeightMap& east = database->find(keys[1])->heights();
      const TeHeightMap& west = database->find(keys[2])->heights();
      ASSERT_EQ(
          std::memcmp(middle.row(n), database->find(keys[3])->heights().row(0), (n + 1) * sizeof(float)), 0);
      ASSERT_EQ(
          std::memcmp(middle.row(0), database->find(keys[4])->heights().row(n), (n + 1) * sizeof(float)), 0);
      for (int y = 0; y <= n; ++y) {
        ASSERT_EQ(std::memcmp(middle.row(y) + n, east.row(y), sizeof(float)), 0);
        ASSERT_EQ(std::memcmp(middle.row(y), west.row(y) + n, sizeof(float)), 0);
      }
      rows += 4;
      ++runs;
      if (!reference)
        reference = std::move(database);
      else
        for (const TePatchKey& key : keys)
          ASSERT_TRUE(sameBits(database->find(key)->heights(), reference->find(key)->heights()));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  std::printf("SharedBorder: %d runs in every order and slice length, %d common rows, 0 bits differ\n", runs,
              rows);
}
