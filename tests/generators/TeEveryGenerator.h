#pragma once

#include "generators/TeGeneratorRegistry.h"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

/// A generator with filters over it, by specification.
struct TeChainUnderTest {
  std::string generator;
  std::vector<std::string> filters;

  /// A name for tests: letters, digits and '_'.
  std::string name() const {
    std::string name;
    for (char c : generator.substr(0, generator.find(':')))
      name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    for (const std::string& filter : filters)
      name += "_" + filter;
    return name;
  }
};

inline void PrintTo(const TeChainUnderTest& chain, std::ostream* out) { *out << chain.name(); }

/// A small raster of metres for the generator of elevation data, 10 m apart, with some posts missing;
/// headerless, so that it needs no GDAL. Deleted at the end of the process.
class TeElevationFileUnderTest {
public:
  TeElevationFileUnderTest()
      : m_path(std::filesystem::temp_directory_path() /
               ("terrane_every_generator_" + std::to_string(getpid()) + ".raw")) {
    std::ofstream out(m_path, std::ios::binary);
    for (int y = 0; y < 50; ++y)
      for (int x = 0; x < 60; ++x) {
        const int height = (x * 7 + y * 3) % 97 == 0 ? -9999 : (x * x + 3 * y * x) % 211;
        out.put(char(height & 0xFF));
        out.put(char((height >> 8) & 0xFF));
      }
  }
  ~TeElevationFileUnderTest() {
    std::error_code ignored;
    std::filesystem::remove(m_path, ignored);
  }
  std::string specification() const {
    return "elevation:encoding=raw,raw-size=60x50,no-data=-9999,posts=10,file=\"" + m_path.string() + "\"";
  }

private:
  std::filesystem::path m_path;
};

/// Every registered generator by itself, with its defaults.
inline std::vector<TeChainUnderTest> teEveryGeneratorAlone() {
  static const TeElevationFileUnderTest file;
  std::vector<TeChainUnderTest> all;
  for (const std::string& generator : TeGeneratorRegistry::instance().generatorNames())
    all.push_back({generator == "elevation" ? file.specification() : generator, {}});
  return all;
}

/// These, and every registered filter over a generator that fits and over one that does not. So laws stated
/// for all of them hold for generators to come as well.
inline std::vector<TeChainUnderTest> teEveryGenerator() {
  std::vector<TeChainUnderTest> all = teEveryGeneratorAlone();
  const std::vector<std::string> filters = TeGeneratorRegistry::instance().filterNames();
  for (const std::string& filter : filters) {
    all.push_back({"function", {filter}});
    all.push_back({"faults", {filter}});
  }
  all.push_back({"faults", filters});
  return all;
}
