#include "apps/terrane-accuracy/TeLodCommand.h"

#include "apps/common/TeExit.h"
#include "apps/common/TeProgressLine.h"
#include "apps/terrane-accuracy/TeLayoutText.h"
#include "apps/terrane-accuracy/TeSeamlessMethod.h"
#include "generators/base/TeText.h"

#include <cstdio>

namespace {

const std::vector<std::string> kMethods = {"seamless", "seamless-geomorph"};
const std::vector<double> kDefaultPixels = {0.5, 1, 2, 4, 8, 16, 32};

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
      ->check(CLI::Validator(teCheckLayout, ""))
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
      teReadLayout(layout, settings.minResolution, settings.levels);
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

TeFlyover TeLodCommand::flight(const TeMeasuredTerrain& terrain) const {
  TeFlyover flight = terrain.flyover();
  flight.width = m_commandLine.common().width;
  flight.height = m_commandLine.common().height;
  return flight;
}

TeStatus TeLodCommand::measure(const TeMeasuredTerrain& terrain, const std::vector<Candidate>& candidates,
                               TeFlightStage* stage, TeLodTable& table) const {
  const TeFlyover flight = this->flight(terrain);
  const std::vector<TeDial> dials = this->dials();
  TeProgressLine progress("Measuring", m_commandLine.common().quiet);
  const double total = double(candidates.size() * dials.size()) * frames();
  double done = 0;
  for (const Candidate& candidate : candidates)
    for (const TeDial& dial : dials) {
      const TeLodFigures figures = teMeasureLod(*candidate.method, dial, terrain, flight, frames(), m_stride,
                                                [&](int frame) { progress.update((done + frame) / total); });
      done += frames();
      std::optional<TeFrameFigures> drawn;
      if (stage) {
        const TeResult<TeFrameFigures> result =
            teMeasureFrames(*candidate.method, dial, terrain, flight, frames(), m_stride, *stage);
        if (!result)
          return result.error();
        drawn = *result;
      }
      table.add(*candidate.method, candidate.layout, dial, frames(), figures, drawn);
    }
  return {};
}

void TeLodCommand::describe(const TeMeasuredTerrain& terrain, const TeFlightStage* stage,
                            const TeLodTable& table, TeAccuracyOutput& output) const {
  const TeFlyover flight = this->flight(terrain);
  auto& json = output.json();
  json["terrain"] = {{"file", terrain.name},
                     {"samples", terrain.cells() + 1},
                     {"spacing_m", terrain.spacing},
                     {"height_unit_m", terrain.heightScale}};
  json["flight"] = {{"frames", frames()},
                    {"degrees_a_frame", flight.anglePerFrame * m_stride},
                    {"width", flight.width},
                    {"height", flight.height}};
  if (stage)
    json["renderer"] = stage->context().renderer();
  output.addText(
      teFormat("%d² samples, %g m apart; %d frames of the flyover, %g degrees each; %d×%d pixels. ",
               terrain.cells() + 1, terrain.spacing, frames(), flight.anglePerFrame * m_stride, flight.width,
               flight.height) +
      (stage ? "Drawn by " + stage->context().renderer() + "." : std::string("Not drawn.")));
  output.addTable(table.table());
  output.addPlot(table.plot("Error against triangles", "triangles", "triangles of a frame (mean)"),
                 "triangles");
  output.addPlot(
      table.plot("Error against time of selection", "select_ms", "selection, ms of CPU time (median)"),
      "selection");
  if (stage)
    output.addPlot(table.plot("Error against frame time", "frame_ms", "frame, ms (median)"), "frame");
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
  std::unique_ptr<TeFlightStage> stage;
  if (!m_noDraw) {
    TeResult<std::unique_ptr<TeFlightStage>> made =
        TeFlightStage::create(*teContextKind(common.context), common.width, common.height);
    if (!made)
      return teExitWith(TeExitFailure, application, made.error().message);
    stage = std::move(*made);
  }

  TeLodTable table;
  if (const TeStatus ok = measure(*terrain, *candidates, stage.get(), table); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  describe(*terrain, stage.get(), table, output);
  if (!common.quiet)
    std::fputs(table.table().markdown().c_str(), stdout);
  if (const TeStatus ok = output.write(table.table()); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  return TeExitSuccess;
}
