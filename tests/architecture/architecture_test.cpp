// The rules of the house: which layer may include and link what, and that tests mirror sources.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = TERRANE_SOURCE_DIR;
const fs::path kBuild = TERRANE_BINARY_DIR;
/// From the ground up: a layer includes itself and those before it.
const std::vector<std::string> kLayers = {"generators", "patchdb", "nodes", "engine"};

std::vector<fs::path> sourcesOf(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".h" || extension == ".cpp")
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

struct Include {
  std::string path;
  bool quoted;
};

std::vector<Include> includesOf(const fs::path& file) {
  static const std::regex pattern("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"]");
  std::vector<Include> includes;
  std::ifstream stream(file);
  std::smatch match;
  for (std::string line; std::getline(stream, line);)
    if (std::regex_search(line, match, pattern))
      includes.push_back({match[2], match[1] == "\""});
  return includes;
}

std::string contentsOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string firstFolder(const std::string& path) { return path.substr(0, path.find('/')); }

int rankOf(const std::string& layer) {
  const auto found = std::find(kLayers.begin(), kLayers.end(), layer);
  return found == kLayers.end() ? -1 : int(found - kLayers.begin());
}

std::string nameOf(const fs::path& file) { return fs::relative(file, kRoot).string(); }

std::vector<std::string> outputLines(const std::string& command) {
  std::vector<std::string> lines;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe)
    return lines;
  std::array<char, 4096> buffer;
  while (fgets(buffer.data(), int(buffer.size()), pipe)) {
    std::string line = buffer.data();
    while (!line.empty() && line.back() == '\n')
      line.pop_back();
    lines.push_back(line);
  }
  EXPECT_EQ(pclose(pipe), 0) << command;
  return lines;
}

/// Symbols that a library takes from others, without versions.
std::vector<std::string> importedSymbols(const fs::path& library) {
  std::vector<std::string> symbols;
  for (const std::string& line : outputLines(TERRANE_NM " -D --undefined-only '" + library.string() + "'")) {
    std::istringstream words(line);
    std::string kind, symbol;
    words >> kind >> symbol;
    symbols.push_back(symbol.substr(0, symbol.find('@')));
  }
  return symbols;
}

std::vector<std::string> neededLibraries(const fs::path& binary) {
  static const std::regex pattern("\\(NEEDED\\).*\\[([^\\]]+)\\]");
  std::vector<std::string> libraries;
  std::smatch match;
  for (const std::string& line : outputLines("LC_ALL=C " TERRANE_READELF " -d '" + binary.string() + "'"))
    if (std::regex_search(line, match, pattern))
      libraries.push_back(match[1]);
  return libraries;
}

fs::path libraryOf(const std::string& layer) {
  std::string name = layer;
  name[0] = char(std::toupper(name[0]));
  return kBuild / "lib" / ("libTerrane" + name + ".so");
}

bool startsWithAny(const std::string& text, const std::vector<std::string>& starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](const std::string& start) { return text.rfind(start, 0) == 0; });
}

bool isElf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 4> magic{};
  stream.read(magic.data(), 4);
  return stream && magic[0] == 0x7f && magic[1] == 'E' && magic[2] == 'L' && magic[3] == 'F';
}

/// Libraries, modules and applications of the build.
std::vector<fs::path> builtBinaries() {
  std::vector<fs::path> binaries;
  for (const char* folder : {"lib", "bin"}) {
    if (!fs::exists(kBuild / folder))
      continue;
    for (const auto& entry : fs::recursive_directory_iterator(kBuild / folder)) {
      const std::string name = entry.path().filename().string();
      const bool test = name.find("_test") != std::string::npos || name.find("bench") != std::string::npos;
      if (entry.is_regular_file() && !entry.is_symlink() && !test && isElf(entry.path()))
        binaries.push_back(entry.path());
    }
  }
  return binaries;
}

TEST(Architecture, ALayerIncludesOnlyItselfAndThoseBelow) {
  for (const std::string& layer : kLayers)
    for (const fs::path& file : sourcesOf(kRoot / layer))
      for (const Include& include : includesOf(file)) {
        const int rank = rankOf(firstFolder(include.path));
        EXPECT_LE(rank, rankOf(layer)) << nameOf(file) << " includes " << include.path;
        EXPECT_TRUE(rank >= 0 || !include.quoted)
            << nameOf(file) << " includes \"" << include.path << "\": paths of the project start at a layer";
      }
}

TEST(Architecture, NothingInALayerIncludesAppsOrTests) {
  for (const std::string& layer : kLayers)
    for (const fs::path& file : sourcesOf(kRoot / layer))
      for (const Include& include : includesOf(file))
        EXPECT_FALSE(startsWithAny(include.path, {"apps/", "tests/", "gtest/", "gmock/"}))
            << nameOf(file) << " includes " << include.path;
}

TEST(Architecture, NoCoinWindowOrGlBelowNodes) {
  for (const char* layer : {"generators", "patchdb"}) {
    for (const fs::path& file : sourcesOf(kRoot / layer))
      for (const Include& include : includesOf(file))
        EXPECT_FALSE(startsWithAny(include.path, {"Inventor/", "GL/", "GLES", "EGL/", "Qt", "Q", "X11/"}))
            << nameOf(file) << " includes " << include.path;
    for (const std::string& library : neededLibraries(libraryOf(layer)))
      EXPECT_FALSE(startsWithAny(
          library, {"libCoin", "libSoQt", "libGL", "libEGL", "libOpenGL", "libOSMesa", "libQt", "libX"}))
          << layer << " needs " << library;
  }
}

TEST(Architecture, ElevationLibrariesOnlyInModules) {
  for (const std::string& layer : kLayers)
    for (const std::string& library : neededLibraries(libraryOf(layer)))
      EXPECT_FALSE(startsWithAny(library, {"libgdal", "libproj"})) << layer << " needs " << library;
}

TEST(Architecture, OwnHeaderComesFirst) {
  for (const std::string& layer : kLayers)
    for (const fs::path& file : sourcesOf(kRoot / layer)) {
      fs::path header = file;
      header.replace_extension(".h");
      if (file.extension() != ".cpp" || !fs::exists(header))
        continue;
      const std::vector<Include> includes = includesOf(file);
      ASSERT_FALSE(includes.empty()) << nameOf(file);
      EXPECT_EQ(includes.front().path, nameOf(header)) << nameOf(file);
    }
}

/// A header has a type of its own name, or is one of functions with the types that belong to them.
TEST(Architecture, FilesAreNamedAfterTheirClass) {
  static const std::regex types(
      "(^|\n)(template <[^>]*> )?(class|struct|enum class) (\\[\\[nodiscard\\]\\] )?((So)?Te\\w+)");
  for (const std::string& layer : kLayers)
    for (const fs::path& file : sourcesOf(kRoot / layer)) {
      if (file.extension() != ".h")
        continue;
      const std::string text = contentsOf(file);
      std::set<std::string> names;
      for (std::sregex_iterator it(text.begin(), text.end(), types), end; it != end; ++it)
        if (text.compare(std::size_t(it->position() + it->length()), 1, ";") != 0)
          names.insert((*it)[5]);
      static const std::regex function("\\n[^/\\n]*\\bte[A-Z]\\w*\\(");
      EXPECT_TRUE(names.empty() || names.count(file.stem().string()) || std::regex_search(text, function))
          << nameOf(file);
    }
}

TEST(Architecture, NoLayerImportsAnOpenGlSymbol) {
  static const std::regex gl("^(gl[A-Z0-9]|glX|egl[A-Z]|OSMesa)\\w*");
  for (const std::string& layer : kLayers) {
    const std::vector<std::string> symbols = importedSymbols(libraryOf(layer));
    EXPECT_FALSE(symbols.empty()) << layer;
    for (const std::string& symbol : symbols)
      EXPECT_FALSE(std::regex_match(symbol, gl)) << layer << " imports " << symbol;
  }
}

/// Every library that ours may link directly, with its licence. A new one is added here after a look at it.
TEST(Architecture, OnlyKnownLicencesAreLinked) {
  const std::vector<std::string> allowed = {
      "libTerrane",                                                                        // ours
      "libc.so",       "libm.so",       "libstdc++.so",     "libgcc_s.so",     "ld-linux", // system
      "libdl.so",      "libpthread.so", "librt.so",         "libasan.so",      "libubsan.so",
      "libtsan.so",    "libCoin.so",    "libSoQt.so",                                       // BSD-3-Clause
      "libgdal.so",    "libproj.so",                                                        // MIT
      "libOSMesa.so",  "libEGL.so",     "libOpenGL.so",     "libGL.so",        "libGLX.so", // MIT
      "libspdlog.so",  "libfmt.so",                                                         // MIT
      "libpng16.so",   "libz.so",                                                           // libpng, zlib
      "libQt5Core.so", "libQt5Gui.so",  "libQt5Widgets.so", "libQt5OpenGL.so",              // LGPL-3
      "libX11.so",                                                                          // MIT
      "libmeshoptimizer.so",                                                                // MIT
  };
  const std::vector<fs::path> binaries = builtBinaries();
  EXPECT_GE(binaries.size(), kLayers.size());
  for (const fs::path& binary : binaries)
    for (const std::string& library : neededLibraries(binary))
      EXPECT_TRUE(startsWithAny(library, allowed)) << binary.filename() << " needs " << library;
}

/// Every file under a folder that includes a header, by the header's path.
std::map<std::string, std::vector<fs::path>> includersIn(const std::vector<std::string>& folders) {
  std::map<std::string, std::vector<fs::path>> includers;
  for (const std::string& folder : folders)
    for (const fs::path& file : sourcesOf(kRoot / folder))
      for (const Include& include : includesOf(file))
        includers[include.path].push_back(file);
  return includers;
}

bool holdsTests(const fs::path& folder) {
  if (!fs::exists(folder))
    return false;
  const std::vector<fs::path> files = sourcesOf(folder);
  return std::any_of(files.begin(), files.end(), [](const fs::path& file) {
    return file.stem().string().find("_test") != std::string::npos;
  });
}

/// Headers that no test names, each with the test that covers them.
const std::map<std::string, std::string> kCoveredElsewhere = {
    {"generators/TeFilter.h", "tests/generators/TeEveryGenerator_test.cpp"},
    {"generators/TeSourceChooser.h", "tests/generators/TeRegionChooser_test.cpp"},
    {"generators/base/TeResult.h", "tests/generators/TeLattice_test.cpp"},
    {"generators/base/TeText.h", "tests/generators/TeGeneratorRegistry_test.cpp"},
    {"generators/elevation/TeElevationOptions.h", "tests/generators/elevation/TeElevationFile_test.cpp"},
    {"generators/elevation/TeRasterFile.h", "tests/generators/elevation/TeElevationFile_test.cpp"},
    {"generators/faults/TeFaultPainter.h", "tests/generators/faults/TeFaultFormation_test.cpp"},
    {"generators/faults/TeFaultPlane.h", "tests/generators/faults/TeFaultFormation_test.cpp"},
    {"nodes/TeWorldRect.h", "tests/nodes/TePatchGraphBuilder_test.cpp"},
    {"nodes/context/TeContextBackend.h", "tests/render/TeContext_test.cpp"},
    {"nodes/context/TeContextKind.h", "tests/render/TeContext_test.cpp"},
    {"nodes/context/TeGlTable.h", "tests/render/TeContext_test.cpp"},
    {"nodes/context/modules/TeSoQtApplication.h", "tests/apps/terraneStaticPictures_test.cpp"},
    {"nodes/lod/drawing/TeLodRays.h", "tests/nodes/lod/SoTeLodTerrain_test.cpp"},
    {"nodes/lod/drawing/TeLodViewers.h", "tests/nodes/lod/SoTeLodTerrain_test.cpp"},
    {"nodes/terrain/TeMeshGl.h", "tests/render/TeMeshBuffers_test.cpp"},
    {"patchdb/TeRayHit.h", "tests/patchdb/TePatchDatabase_test.cpp"},
    {"patchdb/TeTargetClones.h", "tests/patchdb/TeFourMapBlend_test.cpp"},
};

/// A header has a test of its own name; or is used by some test; or is an inner part, which nothing outside
/// its folder includes, of a component that has tests; or is listed above.
TEST(Architecture, TestsMirrorSources) {
  auto inLayers = includersIn(kLayers);
  // The list of all generators makes none of them less of an inner part.
  for (auto& [header, includers] : inLayers)
    includers.erase(
        std::remove(includers.begin(), includers.end(), kRoot / "generators/TeBuiltInGenerators.cpp"),
        includers.end());
  const auto inTests = includersIn({"tests"});
  for (const auto& [header, test] : kCoveredElsewhere) {
    EXPECT_TRUE(fs::exists(kRoot / header)) << header << " is listed, but does not exist";
    EXPECT_TRUE(fs::exists(kRoot / test)) << header << " is said to be covered by " << test;
  }
  for (const std::string& layer : kLayers)
    for (const fs::path& file : sourcesOf(kRoot / layer)) {
      const std::string header = nameOf(file);
      const fs::path folder = fs::path(header).parent_path();
      if (file.extension() != ".h" || inTests.count(header))
        continue;
      const auto includers = inLayers.find(header);
      const bool inner =
          includers != inLayers.end() &&
          std::all_of(includers->second.begin(), includers->second.end(),
                      [&](const fs::path& by) { return by.parent_path() == file.parent_path(); });
      const fs::path component = folder.filename() == "modules" ? folder.parent_path() : folder;
      const bool covered =
          (inner && holdsTests(kRoot / "tests" / component)) || kCoveredElsewhere.count(header);
      EXPECT_TRUE(covered) << header << " is used by no test";
    }
}

/// Tests of laws that hold for several classes together.
const std::set<std::string> kTestsOfLaws = {
    "tests/engine/quality/TeQualityAndBudget_test.cpp",
    "tests/generators/TeEveryGenerator_test.cpp",
    "tests/generators/elevation/RealElevationData_test.cpp",
    "tests/generators/noise/TeNoiseReference_test.cpp",
    "tests/nodes/lod/LodFlight_test.cpp",
    "tests/nodes/lod/quadtree/SmallestMesh_test.cpp",
    "tests/nodes/seamless/ErrorBoundHolds_test.cpp",
    "tests/patchdb/FittingBorders_test.cpp",
};

TEST(Architecture, EveryTestFileHasItsHeader) {
  for (const std::string& layer : kLayers) {
    if (!fs::exists(kRoot / "tests" / layer))
      continue;
    for (const fs::path& file : sourcesOf(kRoot / "tests" / layer)) {
      std::string stem = file.stem().string();
      if (stem.size() < 5 || stem.substr(stem.size() - 5) != "_test" || kTestsOfLaws.count(nameOf(file)))
        continue;
      stem.resize(stem.size() - 5);
      const fs::path folder = fs::relative(file.parent_path(), kRoot / "tests");
      EXPECT_TRUE(fs::exists(kRoot / folder / (stem + ".h"))) << nameOf(file) << " mirrors no header";
    }
  }
}

} // namespace
