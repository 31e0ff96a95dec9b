#include "tests/bench/TeSourceBenchmark.h"

#include <filesystem>
#include <fstream>

namespace {

constexpr int kPosts = 1000;

/// Rough hills of 1000×1000 posts, in the temporary folder until the program ends.
class HillsFile {
public:
  /// An Arc ASCII grid in degrees, or headerless 16 bit data.
  HillsFile(const char* name, bool text) : m_path((std::filesystem::temp_directory_path() / name).string()) {
    std::ofstream out(m_path, std::ios::binary);
    if (text)
      out << "ncols 1000\nnrows 1000\nxllcorner -121\nyllcorner 46\ncellsize 0.0003\n";
    for (int row = 0; row < kPosts; ++row)
      for (int column = 0; column < kPosts; ++column) {
        const int height = (row * 7919 + column * 104729) % 1000;
        if (text)
          out << height << ' ';
        else
          out.put(char(height & 255)).put(char(height >> 8));
      }
  }
  ~HillsFile() { std::filesystem::remove(m_path); }
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

/// Posts in metres; no GDAL.
std::string metres() {
  static const HillsFile file("terrane-bench.raw", false);
  return "elevation:encoding=raw,raw-size=1000x1000,posts=30,outside=clamp,file=" + file.path();
}

/// Posts in degrees.
std::string degrees() {
  static const HillsFile file("terrane-bench.asc", true);
  return "elevation:outside=clamp,file=" + file.path();
}

void metresMap(benchmark::State& state) { teSourceBenchmark(state, metres()); }
void degreesMap(benchmark::State& state) { teSourceBenchmark(state, degrees()); }
void degreesPoints(benchmark::State& state) { tePointBenchmark(state, degrees()); }

} // namespace

BENCHMARK(metresMap)->Name("elevation/map from posts in metres")->Arg(65)->Arg(257)->Arg(1025);
BENCHMARK(degreesMap)->Name("elevation/map from posts in degrees")->Arg(65)->Arg(257)->Arg(1025);
BENCHMARK(degreesPoints)->Name("elevation/every n-th sample, degrees")->Arg(1)->Arg(8)->Arg(64);
