#include "apps/terrane-accuracy/TeInstancingCommand.h"

#include "apps/common/TeProgressLine.h"
#include "apps/terrane-accuracy/TeLayoutText.h"
#include "generators/base/TeText.h"

namespace {

constexpr int kFramesPerSecond = 30;
constexpr double kMetresPerSecond = 500;
constexpr double kClearance = 100; ///< metres
constexpr double kFarDistance = 60000;

constexpr int kPublishedResolution = 16384;

/// The document's figures, measured on a GeForce 9600 GT.
struct Published {
  double precision;
  bool instanced;
  double drawCalls, triangles, ms;
};
constexpr Published kPublished[] = {{4, true, 46, 656702, 2.079},
                                    {4, false, 1839, 650459, 2.819},
                                    {1, true, 43, 68562, 0.926},
                                    {1, false, 250, 67971, 0.961}};

const char* nameOf(TeInstancingWay way) {
  const char* const names[] = {"whole", "instanced", "classic"};
  return names[int(way)];
}

TeTable::Cell published(double precision, TeInstancingWay way, double Published::*value) {
  for (const Published& line : kPublished)
    if (line.precision == precision && line.instanced == (way == TeInstancingWay::Instanced) &&
        way != TeInstancingWay::Whole)
      return line.*value;
  return {};
}

} // namespace

TeInstancingCommand::TeInstancingCommand(TeCommandLine& commandLine)
    : TeAccuracyCommand(commandLine, "instancing",
                        "Measures instanced and classic drawing of Seamless Patches on a flight") {
  const std::string group = "Terrain";
  CLI::Option* clipmaps =
      cli()
          .add_option("--clipmaps", m_clipmaps, "Height pyramid NAME_i.raw, seen through clipmaps")
          ->check(TeCommandLine::notEmpty())
          ->option_text("NAME")
          ->group(group);
  cli()
      .add_option("--map", m_map, "One map of 2^n + 1 samples a side of 16 bits, the first row in the south")
      ->check(TeCommandLine::notEmpty())
      ->option_text("FILE.raw")
      ->excludes(clipmaps)
      ->group(group);
  addNumber("--cells", m_cells, 1e-3, 1e6, "Metres between samples (default: 10)")
      ->option_text("METRES")
      ->group(group);
  addNumber("--height-unit", m_heightUnit, 0, 1e6, "Metres of one step of the heights (default: 0.1)")
      ->option_text("METRES")
      ->group(group);
  addInteger("--clip-size", m_clipSize, TeClipWindows::kMinSize, TeClipWindows::kMaxSize,
             "Samples a side of a window (default: 513)")
      ->needs(clipmaps)
      ->group(group);
  cli()
      .add_option_function<std::string>(
          "--layout", [this](const std::string& text) { teReadLayout(text, m_minResolution, m_levels); },
          "Lowest resolution of a patch and number of resolutions (default: 16/3)")
      ->check(CLI::Validator(teCheckLayout, ""))
      ->option_text("LOWEST/LEVELS")
      ->group(kGroup);
  addList("--precision", m_precisions, TeCommandLine::within(1, 1e4),
          "The document's precision factors (default: 1,4)");
  addNoDraw("Measure selection only");
  addOutput();
}

TeResult<TeInstancingTerrain> TeInstancingCommand::open() const {
  if (!m_clipmaps.empty())
    return TeInstancingTerrain::ofPyramid(m_clipmaps, m_cells, m_heightUnit, m_clipSize);
  if (m_map.empty())
    return TeError{"--clipmaps or --map is required"};
  TeResult<TeMeasuredTerrain> map = TeMeasuredTerrain::readMap(m_map, m_cells, m_heightUnit);
  if (!map)
    return map.error();
  return TeInstancingTerrain::ofMap(std::move(*map));
}

TeStatus TeInstancingCommand::read() {
  if (const TeStatus ok = keep(open(), m_terrain); !ok)
    return ok;
  const TeResult<TeSeamlessLayout> layout =
      TeSeamlessLayout::create(m_terrain->cells(), m_minResolution, m_levels);
  return layout ? TeStatus() : TeStatus(layout.error());
}

TeFlyover TeInstancingCommand::flight() const {
  constexpr double kDegreesARadian = 57.29577951308232;
  TeFlyover flight = m_terrain->flyover();
  flight.clearance = kClearance;
  flight.farDistance = kFarDistance;
  flight.width = common().width;
  flight.height = common().height;
  flight.anglePerFrame =
      kDegreesARadian * kMetresPerSecond / kFramesPerSecond / (flight.radius * flight.cells * flight.spacing);
  return flight;
}

int TeInstancingCommand::frames() const { return framesOr(20 * kFramesPerSecond); }

std::vector<int> TeInstancingCommand::resolutions() const {
  // A quarter as many samples, where files have them.
  const int coarse = m_terrain->cells() / 4;
  if (m_terrain->clipSize() > 0 && coarse + 1 > m_terrain->clipSize())
    return {m_terrain->cells(), coarse};
  return {m_terrain->cells()};
}

void TeInstancingCommand::addRow(TeInstancingWay way, int resolution, double precision,
                                 const TeSelectionFigures& chosen,
                                 const std::optional<TeByWay<TeDrawingFigures>>& drawn, TeTable& table) {
  using Cell = TeTable::Cell;
  const auto document = [&](double Published::*value) {
    return resolution == kPublishedResolution ? published(precision, way, value) : Cell();
  };
  const TeDrawingFigures figures = drawn ? (*drawn)[std::size_t(way)] : TeDrawingFigures();
  const auto ofFrames = [&](double value) { return drawn ? Cell(value) : Cell(); };
  table.addRow({std::string(nameOf(way)),
                std::int64_t(resolution),
                precision,
                drawn ? figures.drawCalls : chosen.drawCalls[std::size_t(way)],
                document(&Published::drawCalls),
                drawn ? figures.triangles : chosen.triangles,
                document(&Published::triangles),
                chosen.ms.median,
                chosen.ms.low,
                chosen.ms.high,
                chosen.ms.mean,
                ofFrames(figures.frameMs.median),
                ofFrames(figures.frameMs.low),
                ofFrames(figures.frameMs.high),
                ofFrames(figures.frameMs.mean),
                document(&Published::ms),
                chosen.patches,
                chosen.visited,
                chosen.nsPerPatch,
                chosen.plainVisited,
                chosen.plainNsPerPatch,
                chosen.nsPerPatch / chosen.plainNsPerPatch,
                ofFrames(figures.uploadBytes)});
}

TeStatus TeInstancingCommand::fly(TeFlightStage* stage, TeTable& table) const {
  const TeFlyover flight = this->flight();
  for (const int resolution : resolutions()) {
    const TeResult<TeSeamlessLayout> layout = TeSeamlessLayout::create(resolution, m_minResolution, m_levels);
    if (!layout)
      return layout.error();
    TeResult<std::shared_ptr<const TeSeamlessBounds>> bounds = [&] {
      TeProgressLine progress("Measuring heights", common().quiet);
      return m_terrain->bounds(*layout, [&](double done) {
        progress.update(done);
        return true;
      });
    }();
    if (!bounds)
      return bounds.error();
    const TeInstancingSweep sweep(*m_terrain, *bounds, flight, frames());
    TeFlightStage* shown = resolution == m_terrain->cells() ? stage : nullptr;
    for (const double precision : m_precisions) {
      TeProgressLine progress(teFormat("Flying, %d, precision %g", resolution, precision), common().quiet);
      const auto step = [&](int frame) { progress.update(double(frame) / frames()); };
      const TeResult<TeSelectionFigures> chosen = sweep.select(precision, step);
      if (!chosen)
        return chosen.error();
      std::optional<TeByWay<TeDrawingFigures>> drawn;
      if (shown) {
        TeResult<TeByWay<TeDrawingFigures>> result = sweep.draw(precision, *shown, step);
        if (!result)
          return result.error();
        drawn = *result;
      }
      for (const TeInstancingWay way : kTeInstancingWays)
        addRow(way, resolution, precision, *chosen, drawn, table);
    }
  }
  return {};
}

void TeInstancingCommand::describe(const TeFlightStage* stage, const TeTable& table,
                                   TeAccuracyOutput& output) const {
  const TeInstancingTerrain& terrain = *m_terrain;
  const TeFlyover flight = this->flight();
  auto& json = output.json();
  json["terrain"] = {{"name", terrain.name()},
                     {"samples", terrain.cells() + 1},
                     {"spacing_m", terrain.spacing()},
                     {"height_unit_m", terrain.heightScale()},
                     {"clip_size", terrain.clipSize()}};
  json["layout"] = {{"min_resolution", m_minResolution}, {"levels", m_levels}};
  json["flight"] = {{"frames", frames()},
                    {"frames_a_second", kFramesPerSecond},
                    {"metres_a_second", kMetresPerSecond},
                    {"clearance_m", kClearance},
                    {"far_m", kFarDistance},
                    {"width", flight.width},
                    {"height", flight.height}};
  if (stage)
    json["renderer"] = stage->context().renderer();
  output.addText(
      teFormat("%d² samples, %g m apart; patches of %d/%d; %d frames of an arc around the middle, ",
               terrain.cells() + 1, terrain.spacing(), m_minResolution, m_levels, frames()) +
      teFormat("%d a second at %g m/s, %g m above the ground, 8° down; %d×%d pixels. ", kFramesPerSecond,
               kMetresPerSecond, kClearance, flight.width, flight.height) +
      (stage ? "Drawn by " + stage->context().renderer() + "." : std::string("Not drawn.")));
  output.addTable(table);
}

TeResult<TeTable> TeInstancingCommand::measure(TeAccuracyOutput& output) {
  const TeResult<std::unique_ptr<TeFlightStage>> stage = makeStage();
  if (!stage)
    return stage.error();
  TeTable table({"method",
                 "resolution",
                 "precision",
                 "draw_calls",
                 "document_draw_calls",
                 "triangles",
                 "document_triangles",
                 "select_ms",
                 "select_low_ms",
                 "select_high_ms",
                 "select_mean_ms",
                 "frame_ms",
                 "frame_low_ms",
                 "frame_high_ms",
                 "frame_mean_ms",
                 "document_frame_ms",
                 "patches",
                 "visited",
                 "ns_a_visited",
                 "plain_visited",
                 "plain_ns_a_visited",
                 "select_ratio",
                 "upload_bytes"});
  if (const TeStatus ok = fly(stage->get(), table); !ok)
    return ok.error();
  describe(stage->get(), table, output);
  return table;
}
