#include "apps/terrane-accuracy/TeAllCommand.h"

#include "apps/common/TeExit.h"
#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeSmoothLand.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

namespace {

constexpr double kSteps = 65535;

/// The middle of a terrain in whole units that take 16 bits, so that all parts read the same file.
TeResult<TeMeasuredTerrain> middleOf(const TeMeasuredTerrain& terrain, int samples) {
  const int side = std::min(samples, terrain.heights().width());
  const int first = (terrain.heights().width() - side) / 2;
  const TeMapRect from{first, first, side, side};
  TeResult<TeHeightMap> map = TeHeightMap::create(side, side);
  if (!map)
    return map.error();
  const TeResult<TeMapStatistics> statistics = terrain.heights().statistics(from);
  if (!statistics)
    return statistics.error();
  const double relief = (double(statistics->maximum) - statistics->minimum) * terrain.heightScale();
  const double unit = std::max(relief / kSteps, 1e-6);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      map->at(x, y) = float(
          std::clamp(std::round((double(terrain.heights().at(first + x, first + y)) - statistics->minimum) *
                                terrain.heightScale() / unit),
                     0.0, kSteps));
  return TeMeasuredTerrain::create(std::filesystem::path(terrain.name).filename().string(), std::move(*map),
                                   terrain.spacing(), unit);
}

TeStatus writeMap(const TeMeasuredTerrain& terrain, const std::string& file) {
  std::ofstream stream(file, std::ios::binary);
  const std::size_t count = terrain.heights().bytes() / sizeof(float);
  for (std::size_t i = 0; i < count; ++i) {
    const int height = int(terrain.heights().data()[i]);
    stream.put(char(height & 255)).put(char(height >> 8));
  }
  stream.close();
  if (!stream)
    return TeError{file + ": cannot be written"};
  return {};
}

std::string processor() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  return "an unknown processor";
}

} // namespace

TeAllCommand::TeAllCommand(TeCommandLine& commandLine, Program program)
    : m_commandLine(commandLine), m_program(program),
      m_cli(commandLine.cli().add_subcommand("all",
                                             "Runs all of these and writes one page of what they measure")) {
  m_cli->fallthrough();
  m_terrain.addTo(*m_cli);
  const std::string group = "Measuring";
  m_cli->add_option("--samples-log", m_samplesLog, "Look at the middle 2^N + 1 samples a side (default: 10)")
      ->transform(TeCommandLine::wholeWithin(6, 12))
      ->option_text("N")
      ->group(group);
  m_cli->add_flag("--quick", m_quick, "A few frames, maps and queries, to see that all of it works")
      ->group(group);
  m_cli->add_flag("--no-draw", m_noDraw, "Measure what the CPU does only")->group(group);
  m_cli->add_option("--out", m_folder, "Folder for accuracy.md, images/accuracy and accuracy (default: docs)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("DIR")
      ->group(group);
  m_cli->add_option("--work", m_work, "Folder for what the parts write (default: accuracy)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("DIR")
      ->group(group);
}

TeResult<TeMeasuredTerrain> TeAllCommand::land() const {
  const int samples = (1 << m_samplesLog) + 1;
  if (m_terrain.map.empty() && m_terrain.dem.empty())
    return middleOf(
        TeMeasuredTerrain::create("mountains", teMountains(samples), TeSmoothLand::kSpacing, 1).value(),
        samples);
  const TeResult<TeMeasuredTerrain> terrain = m_terrain.read();
  if (!terrain)
    return terrain.error();
  return middleOf(*terrain, samples);
}

std::string TeAllCommand::mapFile(const TeMeasuredTerrain& terrain) const {
  return m_work + "/all_" + std::filesystem::path(terrain.name).stem().string() + ".raw";
}

std::vector<TeAllCommand::Part> TeAllCommand::parts(const TeMeasuredTerrain& terrain) const {
  using Words = std::vector<std::string>;
  const Words map = {"--map",         mapFile(terrain),
                     "--cells",       teNumberText(terrain.spacing()),
                     "--height-unit", teNumberText(terrain.heightScale())};
  std::vector<Part> parts;
  const auto add = [&](const std::string& name, const std::string& heading, const Words& full,
                       const Words& quick, const Words& columns = {}) {
    Part part{name, heading, {name}, columns};
    if (name != "generation" && name != "quality")
      part.arguments.insert(part.arguments.end(), map.begin(), map.end());
    const Words& effort = m_quick ? quick : full;
    part.arguments.insert(part.arguments.end(), effort.begin(), effort.end());
    if (m_noDraw && (name == "lod" || name == "instancing" || (name == "quality" && !m_quick)))
      part.arguments.push_back("--no-draw");
    parts.push_back(std::move(part));
  };
  add("lod", "Drawing: level-of-detail methods",
      {"--px", "0.5,1,2,4,8,16,32", "--frames", "12", "--stride", "60"},
      {"--px", "2,16", "--frames", "2", "--stride", "90"},
      {"method", "wanted_px", "triangles", "select_ms", "upload_bytes", "frame_ms", "worst_px", "rms_px",
       "bound_px", "uncovered", "cracks", "popping_px", "bytes_per_sample"});
  add("instancing", "Drawing: instanced and classic Seamless Patches", {"--frames", "60"}, {"--frames", "2"},
      {"method", "precision", "draw_calls", "document_draw_calls", "triangles", "select_ms", "frame_ms",
       "document_frame_ms", "visited", "select_ratio"});
  if (!m_noDraw)
    add("submission", "Drawing: ways to send the same mesh", {"--frames", "15"},
        {"--frames", "2", "--largest", "64", "--px", "8"});
  add("quality", "Drawing: a frame-time goal under a changing load", {"--size", "480x320"},
      {"--no-draw", "--seconds", "2"});
  add("generation", "Generating", {}, {"--samples-log", "5", "--maps", "1", "--runs", "2"});
  add("normals", "Normals", {}, {"--samples-log", "6", "--levels", "3", "--runs", "2"});
  add("height", "Heights and rays", {}, {"--queries", "200", "--runs", "2"});
  return parts;
}

int TeAllCommand::runPart(const Part& part) const {
  std::vector<std::string> words = {m_commandLine.application()};
  words.insert(words.end(), part.arguments.begin(), part.arguments.end());
  const TeCommonOptions& common = m_commandLine.common();
  const auto more = [&](const char* option, const std::string& value) {
    if (std::find(words.begin(), words.end(), option) == words.end())
      words.insert(words.end(), {option, value});
  };
  words.push_back("--quiet");
  more("--out", m_work);
  more("--context", common.context);
  more("--size", teFormat("%dx%d", common.width, common.height));
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  return m_program(int(arguments.size()), arguments.data());
}

void TeAllCommand::introduce(const TeMeasuredTerrain& terrain, TeAccuracyPage& page) const {
  page.addText("# What accuracy costs in time");
  page.addText(
      "Written by `terrane-accuracy all`; what it measures and how: "
      "[terrane-accuracy](terrane-accuracy.md). All but times is the same in every run; times are medians, "
      "to be compared within one part.");
  page.addText(
      teFormat("Terrain: %s, %d² samples, %g m apart, heights in steps of %.3g m. Machine: %s, %u cores.",
               terrain.name.c_str(), terrain.cells() + 1, terrain.spacing(), terrain.heightScale(),
               processor().c_str(), std::thread::hardware_concurrency()));
}

int TeAllCommand::run() {
  const std::string& application = m_commandLine.application();
  const bool quiet = m_commandLine.common().quiet;
  TeAccuracyOutput output(m_commandLine, "all", m_work);
  const TeResult<TeMeasuredTerrain> terrain = land();
  if (!terrain)
    return teExitWith(TeExitUsage, application, terrain.error().message);
  if (const TeStatus ok = output.prepare(); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  std::error_code ignored;
  if (!m_terrain.map.empty() && std::filesystem::equivalent(m_terrain.map, mapFile(*terrain), ignored))
    return teExitWith(TeExitUsage, application, m_terrain.map + ": would be written over");
  if (const TeStatus ok = writeMap(*terrain, mapFile(*terrain)); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);

  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const auto secondsSince = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  TeAccuracyPage page(m_work, m_folder);
  introduce(*terrain, page);
  TeTable table({"part", "seconds", "status"});
  std::string failed;
  for (const Part& part : parts(*terrain)) {
    const Clock::time_point start = Clock::now();
    const int status = runPart(part);
    table.addRow({part.name, secondsSince(start), std::int64_t(status)});
    if (!quiet)
      std::printf("%s: %.1f s\n", part.name.c_str(), secondsSince(start));
    const TeStatus ok = status == TeExitSuccess ? page.addSection(part.name, part.heading, part.columns)
                                                : TeStatus(TeError{});
    if (!ok) {
      failed += (failed.empty() ? "" : ", ") + part.name;
      if (!ok.error().message.empty())
        std::fprintf(stderr, "%s: %s\n", application.c_str(), ok.error().message.c_str());
    }
  }
  page.addText(teFormat("Measured in %.0f s.", secondsSince(begin)));
  if (!quiet)
    std::printf("all: %.1f s\n", secondsSince(begin));
  output.addTable(table);
  if (const TeStatus ok = output.write(table); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  if (const TeStatus ok = page.write(); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  if (!failed.empty())
    return teExitWith(TeExitFailure, application, "failed: " + failed);
  return TeExitSuccess;
}
