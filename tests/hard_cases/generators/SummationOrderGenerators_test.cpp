#include "generators/base/TeRandom.h"
#include "tests/generators/TeEveryGenerator.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <thread>

namespace {

constexpr int kMaps = 24;

TeMapRequest request(int number) {
  static const TeLattice lattice = TeLattice::create(33, 10).value();
  return TeMapRequest::sourceMap(lattice, 99, {number % 5 - 2, number / 5 - 2});
}

/// All maps made by so many workers in slices of random length.
std::vector<TeHeightMap> make(const TeHeightSourcePtr& source, int workers) {
  std::vector<TeHeightMap> maps(kMaps);
  std::atomic<int> next{0};
  const auto work = [&](int worker) {
    TeRandom random(std::uint64_t(worker), 1, {});
    for (int number = next++; number < kMaps; number = next++) {
      const auto job = source->start(request(number));
      while (job->progress() == TeProgress::Working) {
        TeAllowance allowance = TeAllowance::units(1 + std::int64_t(random.below(30)));
        job->step(allowance);
      }
      maps[std::size_t(number)] = job->takeMap();
    }
  };
  std::vector<std::thread> threads;
  for (int worker = 0; worker < workers; ++worker)
    threads.emplace_back(work, worker);
  for (std::thread& thread : threads)
    thread.join();
  return maps;
}

} // namespace

TEST(HardCase, SummationOrderGenerators) {
  int compared = 0;
  for (const TeChainUnderTest& chain : teEveryGenerator()) {
    const auto source = TeGeneratorRegistry::instance().source(chain.generator, chain.filters).value();
    std::vector<TeHeightMap> expected;
    for (int number = 0; number < kMaps; ++number)
      expected.push_back(source->generate(request(number)).value());
    for (int workers : {1, 2, 8, 16}) {
      const std::vector<TeHeightMap> maps = make(source, workers);
      for (int number = 0; number < kMaps; ++number) {
        ASSERT_TRUE(maps[std::size_t(number)] == expected[std::size_t(number)])
            << chain.name() << " with " << workers << " workers, map " << number;
        ++compared;
      }
    }
  }
  std::printf("%d maps from 1, 2, 8 and 16 workers in random slices have the bits of one go\n", compared);
}
