#include "apps/terrane-accuracy/TeAllCommand.h"

#include "apps/common/TeExit.h"
#include "apps/common/TeStopwatch.h"
#include "apps/terrane-accuracy/TeQualityCommand.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

namespace {

constexpr double kSteps = 65535;

/// The middle of a terrain in whole units that take 16 bits, so that all parts read the same file.
TeResult<TeMeasuredTerrain> middleOf(const TeMeasuredTerrain& terrain, int samples) {
  const TeMapRect from = terrain.middle(samples);
  TeResult<TeHeightMap> map = TeHeightMap::create(from.width, from.height);
  if (!map)
    return map.error();
  const TeResult<TeMapStatistics> statistics = terrain.heights().statistics(from);
  if (!statistics)
    return statistics.error();
  const double relief = (double(statistics->maximum) - statistics->minimum) * terrain.heightScale();
  const double unit = std::max(relief / kSteps, 1e-6);
  for (int y = 0; y < from.height; ++y)
    for (int x = 0; x < from.width; ++x)
      map->at(x, y) = float(
          std::clamp(std::round((double(terrain.heights().at(from.x + x, from.y + y)) - statistics->minimum) *
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
    : TeAccuracyCommand(commandLine, "all", "Runs all of these and writes one page of what they measure"),
      m_program(program) {
  m_choice.addTo(cli());
  addInteger("--samples-log", m_samplesLog, 6, 12, "Look at the middle 2^N + 1 samples a side (default: 10)");
  addFlag("--quick", m_quick, "A few frames, maps and queries, to see that all of it works");
  addNoDraw("Measure what the CPU does only");
  addFolder("--out", m_pageFolder, "Folder for accuracy.md, images/accuracy and accuracy (default: docs)");
  addOutput("--work", "Folder for what the parts write (default: accuracy)");
}

TeStatus TeAllCommand::read() {
  const int samples = (1 << m_samplesLog) + 1;
  const TeResult<TeMeasuredTerrain> terrain = m_choice.readOrMountains(samples);
  if (!terrain)
    return terrain.error();
  if (const TeStatus ok = keep(middleOf(*terrain, samples), m_terrain); !ok)
    return ok;
  std::error_code ignored;
  if (!m_choice.map.empty() && std::filesystem::equivalent(m_choice.map, mapFile(), ignored))
    return TeError{m_choice.map + ": would be written over"};
  return {};
}

std::string TeAllCommand::mapFile() const {
  return folder() + "/all_" + std::filesystem::path(m_terrain->name).stem().string() + ".raw";
}

std::vector<TeAllCommand::Part> TeAllCommand::parts() const {
  using Words = std::vector<std::string>;
  const Words map = {"--map",         mapFile(),
                     "--cells",       teNumberText(m_terrain->spacing()),
                     "--height-unit", teNumberText(m_terrain->heightScale())};
  std::vector<Part> parts;
  const auto add = [&](const std::string& name, const std::string& heading, const Words& full,
                       const Words& quick, const Words& columns = {}) {
    Part part{{name, heading, columns}, {name}};
    if (name != "generation" && name != "quality")
      part.arguments.insert(part.arguments.end(), map.begin(), map.end());
    const Words& effort = m_quick ? quick : full;
    part.arguments.insert(part.arguments.end(), effort.begin(), effort.end());
    if (!draws() && (name == "lod" || name == "instancing" || (name == "quality" && !m_quick)))
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
  if (draws())
    add("submission", "Drawing: ways to send the same mesh", {"--frames", "15"},
        {"--frames", "2", "--largest", "64", "--px", "8"});
  add("quality", "Drawing: a frame-time goal under a changing load", {"--size", "480x320"},
      {"--no-draw", "--seconds", "2"});
  parts.back().section.runs = TeQualityCommand::shownRuns();
  add("generation", "Generating", {}, {"--samples-log", "5", "--maps", "1", "--runs", "2"});
  add("normals", "Normals", {}, {"--samples-log", "6", "--levels", "3", "--runs", "2"});
  add("height", "Heights and rays", {}, {"--queries", "200", "--runs", "2"});
  return parts;
}

int TeAllCommand::runPart(const Part& part) const {
  std::vector<std::string> words = {commandLine().application()};
  words.insert(words.end(), part.arguments.begin(), part.arguments.end());
  const auto more = [&](const char* option, const std::string& value) {
    if (std::find(words.begin(), words.end(), option) == words.end())
      words.insert(words.end(), {option, value});
  };
  words.push_back("--quiet");
  more("--out", folder());
  more("--context", common().context);
  more("--size", teFormat("%dx%d", common().width, common().height));
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  return m_program(int(arguments.size()), arguments.data());
}

void TeAllCommand::introduce(TeAccuracyPage& page) const {
  page.addText("# What accuracy costs in time");
  page.addText(
      "Written by `terrane-accuracy all`; what it measures and how: "
      "[terrane-accuracy](terrane-accuracy.md). All but times is the same in every run; times are medians, "
      "to be compared within one part.");
  page.addText(
      teFormat("Terrain: %s, %d² samples, %g m apart, heights in steps of %.3g m. Machine: %s, %u cores.",
               m_terrain->name.c_str(), m_terrain->cells() + 1, m_terrain->spacing(),
               m_terrain->heightScale(), processor().c_str(), std::thread::hardware_concurrency()));
}

TeResult<TeTable> TeAllCommand::measure(TeAccuracyOutput& output) {
  if (const TeStatus ok = writeMap(*m_terrain, mapFile()); !ok)
    return ok.error();
  const bool quiet = common().quiet;
  const TeStopwatch all;
  m_page.emplace(folder(), m_pageFolder);
  introduce(*m_page);
  TeTable table({"part", "seconds", "status"});
  for (const Part& part : parts()) {
    const std::string& name = part.section.name;
    const TeStopwatch time;
    const int status = runPart(part);
    table.addRow({name, time.seconds(), std::int64_t(status)});
    if (!quiet)
      std::printf("%s: %.1f s\n", name.c_str(), time.seconds());
    const TeStatus ok = status == TeExitSuccess ? m_page->addSection(part.section) : TeStatus(TeError{});
    if (!ok) {
      m_failed += (m_failed.empty() ? "" : ", ") + name;
      if (!ok.error().message.empty())
        std::fprintf(stderr, "%s: %s\n", commandLine().application().c_str(), ok.error().message.c_str());
    }
  }
  m_page->addText(teFormat("Measured in %.0f s.", all.seconds()));
  if (!quiet)
    std::printf("all: %.1f s\n", all.seconds());
  output.addText(table.markdown()); // what it says has been printed
  return table;
}

TeStatus TeAllCommand::finish() {
  if (const TeStatus ok = m_page->write(); !ok)
    return ok;
  return m_failed.empty() ? TeStatus() : TeStatus(TeError{"failed: " + m_failed});
}
