// What it costs to move the windows of a clipmap: 513 × 513 samples of each of levels 9 to 12 of a pyramid,
// against a plain copy of the bytes that are uploaded.

#include "nodes/clipmap/TeClipWindows.h"
#include "tests/bench/TeBenchmarkReport.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

constexpr int kTop = 12;
constexpr int kSize = 513;

/// The levels that are needed, in the temporary folder until the program ends.
class PyramidFolder {
public:
  PyramidFolder()
      : m_folder((std::filesystem::temp_directory_path() / ("clipmap-bench-" + std::to_string(::getpid())))
                     .string()) {
    std::filesystem::create_directories(m_folder);
    for (int level = TeClipWindows::wholeLevel(kSize); level <= kTop; level++) {
      const int side = tePyramidSide(level);
      std::string row(std::size_t(side) * 2, ' ');
      std::ofstream file(tePyramidLevelFile(name(), level), std::ios::binary);
      for (int y = 0; y < side; y++) {
        for (std::size_t x = 0; x < row.size(); x++)
          row[x] = char(x * 7919 + std::size_t(y) * 104729);
        file << row;
      }
    }
  }
  ~PyramidFolder() { std::filesystem::remove_all(m_folder); }
  std::string name() const { return m_folder + "/p"; }

private:
  std::string m_folder;
};

std::unique_ptr<TeClipWindows> makeWindows(std::size_t cacheBytes) {
  static const PyramidFolder folder;
  auto reader = TePyramidReader::open(folder.name(), 2, TeClipWindows::wholeLevel(kSize));
  if (!reader)
    std::abort();
  auto tiles = std::make_shared<TePyramidTiles>(std::move(*reader), cacheBytes);
  auto windows = TeClipWindows::create(tiles, kSize);
  if (!windows)
    std::abort();
  return std::move(*windows);
}

/// Back and forth over the terrain, not along an axis, by so many samples of the finest level at a time.
class Flight {
public:
  explicit Flight(double samples) : m_step(samples, samples * 0.25) {}
  glm::dvec2 next() {
    const glm::dvec2 ahead = m_at + m_step;
    if (ahead.x < 600 || ahead.x > 3500)
      m_step = -m_step;
    m_at += m_step;
    return m_at;
  }

private:
  glm::dvec2 m_at{1000, 1000};
  glm::dvec2 m_step;
};

void measure(benchmark::State& state, std::size_t cacheBytes, double step) {
  Flight flight(step);
  const auto windows = makeWindows(cacheBytes);
  windows->update(flight.next(), kTop, 0);
  constexpr int kSample = 256;
  const std::int64_t before = windows->statistics().bytesUploaded;
  Flight sample = flight;
  for (int i = 0; i < kSample; i++)
    windows->update(sample.next(), kTop, 0);
  windows->update(flight.next(), kTop, 0);
  TeBenchmarkWork work;
  work.copyBytes = std::size_t((windows->statistics().bytesUploaded - before) / kSample);
  teBenchmark(state, work, [&] {
    windows->update(flight.next(), kTop, 0);
    windows->clearUploads();
  });
  state.counters["uploaded"] = double(work.copyBytes);
}

void moves(benchmark::State& state) {
  measure(state, TePyramidTiles::kDefaultCacheBytes, double(state.range(0)));
}

/// All tiles are in the cache, which leaves the copying alone.
void movesInCache(benchmark::State& state) { measure(state, std::size_t(256) << 20, double(state.range(0))); }

void jump(benchmark::State& state) {
  const auto windows = makeWindows(std::size_t(state.range(0)) << 20);
  const glm::dvec2 places[] = {{700, 700}, {3300, 3300}};
  int number = 0;
  TeBenchmarkWork work;
  work.copyBytes = 3 * windows->imageBytes();
  teBenchmark(state, work, [&] {
    windows->update(places[number++ % 2], kTop, 0);
    windows->clearUploads();
  });
  state.counters["uploaded"] = double(work.copyBytes);
}

} // namespace

BENCHMARK(moves)->Name("clipmap/move by n samples")->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK(movesInCache)
    ->Name("clipmap/move by n samples, all tiles in memory")
    ->Arg(1)
    ->Arg(16)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(jump)->Name("clipmap/jump, n MB of tiles")->Arg(1)->Arg(256)->Unit(benchmark::kMicrosecond);
