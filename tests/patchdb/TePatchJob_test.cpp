#include "patchdb/TePatchJob.h"

#include "patchdb/TeMapJob.h"
#include "patchdb/TeMapProvider.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <map>

namespace {

/// Makes maps only when it is told to.
class Provider final : public TeMapProvider {
public:
  explicit Provider(TePatchDatabase& database) : m_database(&database) {}
  void request(TeMapKey key) override { ++m_requests[{key.x, key.y}]; }
  void release(TeMapKey key) override { --m_requests[{key.x, key.y}]; }
  bool blocked(TeMapKey) const override { return m_busy; }
  TeProgress provide(TeMapKey key, TeAllowance& allowance, TeSourceMapPtr& map, TeError& error) override {
    if (m_busy)
      return TeProgress::Working;
    TeMapJob job(*m_database, key);
    const TeProgress progress = job.step(allowance);
    if (progress == TeProgress::Done)
      map = job.map();
    else
      error = {"not at once"};
    return progress == TeProgress::Done ? progress : TeProgress::Failed;
  }
  int open() const {
    int sum = 0;
    for (const auto& [key, count] : m_requests)
      sum += count;
    return sum;
  }

  bool m_busy = true;

private:
  TePatchDatabase* m_database;
  std::map<std::pair<std::int64_t, std::int64_t>, int> m_requests;
};

} // namespace

TEST(TePatchJob, GoesThroughItsStages) {
  const auto database = teTestDatabase(std::make_shared<TeHashSource>(), 65);
  TePatchJob job(*database, {2, 3, 0});
  EXPECT_EQ(job.stage(), TePatchJob::Stage::Waiting);
  std::vector<TePatchJob::Stage> stages;
  while (job.progress() == TeProgress::Working) {
    EXPECT_FALSE(job.blocked());
    TeAllowance one = TeAllowance::units(1);
    job.step(one);
    EXPECT_EQ(one.unitsSpent(), 1);
    if (stages.empty() || stages.back() != job.stage())
      stages.push_back(job.stage());
  }
  EXPECT_EQ(stages.front(), TePatchJob::Stage::SourceMaps);
  EXPECT_EQ(stages.back(), TePatchJob::Stage::Ended);
}

TEST(TePatchJob, WaitsForAProviderAndReturnsAllThatItRequested) {
  const auto database = teTestDatabase(std::make_shared<TeHashSource>(), 17);
  Provider provider(*database);
  TeAllowance all = TeAllowance::unlimited();
  {
    TePatchJob job(*database, {0, 0, 0}, &provider);
    EXPECT_EQ(job.step(all), TeProgress::Working);
    EXPECT_TRUE(job.blocked());
    EXPECT_EQ(job.stage(), TePatchJob::Stage::SourceMaps);
    EXPECT_EQ(provider.open(), 4);
  }
  EXPECT_EQ(provider.open(), 0);
  TePatchJob job(*database, {0, 0, 0}, &provider);
  job.step(all);
  provider.m_busy = false;
  EXPECT_FALSE(job.blocked());
  EXPECT_EQ(job.step(all), TeProgress::Done);
  EXPECT_EQ(provider.open(), 0);
  EXPECT_TRUE(database->find({0, 0, 0})->hasHeights());
}

TEST(TePatchJob, AProvidersErrorIsTheJobs) {
  const auto database = teTestDatabase(std::make_shared<TeHashSource>(), 65);
  Provider provider(*database);
  provider.m_busy = false;
  TePatchJob job(*database, {7, 8, 0}, &provider);
  TeAllowance one = TeAllowance::units(1); // too little for a map
  EXPECT_EQ(job.step(one), TeProgress::Failed);
  EXPECT_EQ(job.error().message, "patch (7, 8) level 0: not at once");
  EXPECT_EQ(provider.open(), 0);
}
