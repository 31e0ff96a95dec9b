#include "apps/terrane-accuracy/TeLodCommand.h"

#include "apps/common/TeExit.h"
#include "apps/common/TeProgressLine.h"
#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeSeamlessMethod.h"
#include "generators/base/TeText.h"

#include <cstdio>

namespace {

const std::vector<std::string> kMethods = {"seamless", "seamless-geomorph"};
const std::vector<double> kDefaultPixels = {0.5, 1, 2, 4, 8, 16, 32};
constexpr int kDefaultFrames = 72;

bool readLayout(const std::string& text, int& minResolution, int& levels) {
  int used = 0;
  return std::sscanf(text.c_str(), "%d/%d%n", &minResolution, &levels, &used) == 2 &&
         std::size_t(used) == text.size();
}

std::string checkLayout(std::string& text) {
  int minResolution = 0, levels = 0;
  return readLayout(text, minResolution, levels) ? std::string()
                                                 : "must be LOWEST/LEVELS, such as 16/3, not '" + text + "'";
}

TeTable::Cell known(double value, bool is) { return is ? TeTable::Cell(value) : TeTable::Cell(); }

/// All rows of one method and layout as a curve.
TePlot::Curve curveOf(const TeTable& table, const std::string& method, const std::string& layout,
                      const std::string& x, const std::string& y) {
  TePlot::Curve curve{method + " " + layout, {}, {}};
  for (std::size_t row = 0; row < table.rows(); row++)
    if (std::get<std::string>(table.cell(row, "method")) == method &&
        std::get<std::string>(table.cell(row, "layout")) == layout) {
      curve.x.push_back(table.number(row, x));
      curve.y.push_back(table.number(row, y));
    }
  return curve;
}

} // namespace

TeLodCommand::TeLodCommand(TeCommandLine& commandLine)
    : m_commandLine(commandLine),
      m_cli(commandLine.cli().add_subcommand("lod", "Measures level-of-detail methods on a flight: cost and "
                                                    "true errors")) {
  m_cli->fallthrough();
  m_terrain.addTo(*m_cli);
  const std::string group = "Measuring";
  m_cli->add_flag("--flyover", m_flyover, "Fly the circle of half a degree a frame (default)")->group(group);
  m_cli->add_option("--methods", m_methods, "seamless, seamless-geomorph (default: seamless)")
      ->delimiter(',')
      ->check(CLI::IsMember(kMethods))
      ->option_text("LIST")
      ->group(group);
  m_cli
      ->add_option("--layout", m_layouts,
                   "Lowest resolution of a patch and number of resolutions (default: 16/3)")
      ->delimiter(',')
      ->check(CLI::Validator(checkLayout, ""))
      ->option_text("LIST")
      ->group(group);
  m_cli->add_option("--px", m_pixels, "Wanted screen errors, pixels (default: 0.5,1,2,4,8,16,32)")
      ->delimiter(',')
      ->check(TeCommandLine::within(1e-3, 1e4))
      ->option_text("LIST")
      ->group(group);
  m_cli->add_option("--precision", m_precisions, "The document's precision factors, from 1")
      ->delimiter(',')
      ->check(TeCommandLine::within(1, 1e4))
      ->option_text("LIST")
      ->group(group);
  m_cli->add_option("--stride", m_stride, "Measure every N-th frame of the flight (default: 1)")
      ->transform(TeCommandLine::wholeWithin(1, 720))
      ->option_text("N")
      ->group(group);
  m_cli->add_flag("--no-draw", m_noDraw, "Measure what the CPU does only")->group(group);
  m_cli->add_option("--out", m_folder, "Folder for what is written (default: accuracy)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("DIR")
      ->group(group);
}

TeResult<std::vector<TeLodCommand::Candidate>>
TeLodCommand::candidates(const TeMeasuredTerrain& terrain) const {
  std::vector<Candidate> candidates;
  for (const std::string& method : m_methods)
    for (const std::string& layout : m_layouts) {
      TeSeamlessMethod::Settings settings;
      readLayout(layout, settings.minResolution, settings.levels);
      settings.geomorph = method == "seamless-geomorph";
      TeResult<std::unique_ptr<TeSeamlessMethod>> made = TeSeamlessMethod::create(terrain, settings);
      if (!made)
        return TeError{"--layout " + layout + ": " + made.error().message};
      candidates.push_back({std::move(*made), layout});
    }
  return candidates;
}

std::vector<TeDial> TeLodCommand::dials() const {
  std::vector<TeDial> dials;
  for (const double pixels : m_pixels.empty() && m_precisions.empty() ? kDefaultPixels : m_pixels)
    dials.push_back({pixels, 0});
  for (const double precision : m_precisions)
    dials.push_back({0, precision});
  return dials;
}

int TeLodCommand::run() {
  const std::string& application = m_commandLine.application();
  const TeCommonOptions& common = m_commandLine.common();
  TeAccuracyOutput output(m_commandLine, "lod", m_folder);
  const TeResult<TeMeasuredTerrain> terrain = m_terrain.read();
  if (!terrain)
    return teExitWith(TeExitUsage, application, terrain.error().message);
  const TeResult<std::vector<Candidate>> candidates = this->candidates(*terrain);
  if (!candidates)
    return teExitWith(TeExitUsage, application, candidates.error().message);
  if (const TeStatus ok = output.prepare(); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);

  const TeFlyover flight = [&] {
    TeFlyover flight = terrain->flyover();
    flight.width = common.width;
    flight.height = common.height;
    return flight;
  }();
  const int frames = common.frames > 0 ? common.frames : kDefaultFrames;
  const std::vector<TeDial> dials = this->dials();
  TeTable table({"method",           "wanted_px", "dial",          "triangles",     "select_ms",
                 "upload_bytes",     "frame_ms",  "worst_px",      "p999_px",       "rms_px",
                 "worst_m",          "bound_px",  "uncovered",     "cracks",        "popping_px",
                 "bytes_per_sample", "layout",    "frames",        "overshoots",    "draw_calls",
                 "patches",          "visited",   "select_low_ms", "select_high_ms"});
  {
    TeProgressLine progress("Measuring", common.quiet);
    const double total = double(candidates->size() * dials.size()) * frames;
    double done = 0;
    for (const Candidate& candidate : *candidates)
      for (const TeDial& dial : dials) {
        const TeLodFigures figures =
            teMeasureLod(*candidate.method, dial, *terrain, flight, frames, m_stride,
                         [&](int frame) { progress.update((done + frame) / total); });
        done += frames;
        table.addRow({candidate.method->name(),
                      known(dial.pixels, dial.pixels > 0),
                      figures.dial,
                      figures.triangles,
                      figures.selectMs.median,
                      figures.uploadBytes,
                      {},
                      figures.errors.worstPixels(),
                      figures.errors.p999Pixels(),
                      figures.errors.rmsPixels(),
                      figures.errors.worstMetres(),
                      figures.boundPixels,
                      figures.errors.uncovered(),
                      figures.cracks,
                      figures.errors.popping(),
                      candidate.method->bytesPerSample(),
                      candidate.layout,
                      std::int64_t(frames),
                      figures.overshoots,
                      figures.drawCalls,
                      figures.parts,
                      figures.visited,
                      figures.selectMs.low,
                      figures.selectMs.high});
      }
  }

  output.json()["terrain"] = {{"file", terrain->name},
                              {"samples", terrain->cells() + 1},
                              {"spacing_m", terrain->spacing},
                              {"height_unit_m", terrain->heightScale}};
  output.json()["flight"] = {{"frames", frames}, {"degrees_a_frame", flight.anglePerFrame * m_stride}};
  output.addText(teFormat("%d² samples, %g m apart; %d frames of the flyover, every %d.; %d×%d pixels.",
                          terrain->cells() + 1, terrain->spacing, frames, m_stride, common.width,
                          common.height));
  output.addTable(table);
  const struct {
    const char *suffix, *title, *column, *label;
  } plots[] = {{"triangles", "Error against triangles", "triangles", "triangles in view (mean)"},
               {"time", "Error against time", "select_ms", "selection, ms of CPU time (median)"}};
  for (const auto& plot : plots) {
    TePlot diagram{plot.title, plot.label, "largest true error in view, pixels", true, true, {}};
    for (const Candidate& candidate : *candidates)
      diagram.curves.push_back(
          curveOf(table, candidate.method->name(), candidate.layout, plot.column, "worst_px"));
    output.addPlot(diagram, plot.suffix);
  }
  if (!common.quiet)
    std::fputs(table.markdown().c_str(), stdout);
  if (const TeStatus ok = output.write(table); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  return TeExitSuccess;
}
