#include "apps/terrane-accuracy/TeQualityCommand.h"

#include "apps/common/TeProgressLine.h"
#include "apps/terrane-accuracy/TeQualityPlant.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>

namespace {

/// 1, `load`, 1 again, for so many seconds each; the first time longer, for it begins anywhere.
std::vector<TeQualityTrace::Step> stepsOf(const std::vector<double>& loads, double seconds) {
  std::vector<TeQualityTrace::Step> steps;
  double time = 0;
  for (const double load : loads) {
    steps.push_back({time, time + seconds, load});
    time += seconds;
  }
  return steps;
}

} // namespace

TeQualityCommand::TeQualityCommand(TeCommandLine& commandLine)
    : TeAccuracyCommand(commandLine, "quality",
                        "Shows how a frame-time goal is held by choosing the error under changing load") {
  addInteger("--radius", m_radius, 1, TeEngine::kMaxRadius,
             "Patches around the middle one of the flight (default: 6)");
  addNumber("--fps", m_rate, 1, 1000, "Wanted frames a second (default: what can be held under both loads)");
  addNumber("--load", m_load, 2, 16, "How often the scene is drawn in the middle of the flight (default: 2)");
  addNumber("--seconds", m_seconds, 2, 600, "Of each load (default: 4)");
  addNoDraw("The simulation only");
  addOutput();
}

const std::vector<std::string>& TeQualityCommand::shownRuns() {
  static const std::vector<std::string> names = {"drawn", "simulated, exponent 1"};
  return names;
}

TeResult<TeQualityTrace> TeQualityCommand::drawn(TeAccuracyOutput& output) const {
  TeResult<std::unique_ptr<TeQualityFlight>> flight = TeQualityFlight::create(common(), m_radius);
  if (!flight)
    return flight.error();
  double rate = m_rate;
  if (rate == 0) {
    const TeResult<double> found = (*flight)->findRate(std::round(m_load));
    if (!found)
      return found.error();
    rate = *found;
  }
  const std::vector<TeQualityTrace::Step> steps = stepsOf({1, std::round(m_load), 1}, m_seconds);
  TeProgressLine progress("Flying", common().quiet);
  TeResult<TeQualityTrace> trace =
      (*flight)->run(rate, steps, [&](double seconds) { progress.update(seconds / steps.back().end); });
  if (!trace)
    return trace.error();
  auto& json = output.json();
  json["renderer"] = (*flight)->renderer();
  json["terrain"] = (*flight)->terrain();
  json["frames_a_second"] = rate;
  json["radius"] = m_radius;
  json["clock"] = (*flight)->byCpu() ? "cpu" : "wall";
  output.addText(
      teFormat("Drawn: the engine's terrain, %d × %d patches, from a traveller at 2 m/s, %d×%d "
               "pixels, by ",
               2 * m_radius + 1, 2 * m_radius + 1, common().width, common().height) +
      (*flight)->renderer() +
      ((*flight)->byCpu() ? "; times are CPU time of all threads, as that is what draws here" : "") +
      teFormat("; goal %.1f frames a second, of which drawing gets %.1f ms. The load is how often the "
               "scene is drawn in a frame. Simulated: frames of 60 a second that cost a fixed 15 %% "
               "and a part that falls with the error, ± 10 %% noise, each choice a frame late.",
               rate, 1000 * trace->goal));
  return trace;
}

TeResult<std::vector<TeQualityTrace>> TeQualityCommand::traces(TeAccuracyOutput& output) const {
  std::vector<TeQualityTrace> traces;
  if (draws()) {
    TeResult<TeQualityTrace> trace = drawn(output);
    if (!trace)
      return trace.error();
    traces.push_back(std::move(*trace));
  }
  for (const double exponent : {1.0, 0.5, 2.0}) {
    TeQualityPlant plant;
    plant.exponent = exponent;
    traces.push_back(plant.run(stepsOf({1, 2, 0.5, 2, 1}, m_seconds)));
  }
  return traces;
}

TeTable TeQualityCommand::tableOf(const std::vector<TeQualityTrace>& traces) {
  TeTable table({"run", "time_s", "load", "frame_ms", "goal_ms", "wanted_px", "bound_px", "triangles"});
  for (const TeQualityTrace& trace : traces)
    for (const TeQualityTrace::Frame& frame : trace.frames) {
      const bool isDrawn = frame.triangles > 0;
      table.addRow({trace.name, frame.time, frame.load, 1000 * frame.seconds, 1000 * trace.goal,
                    frame.pixelError, isDrawn ? TeTable::Cell(frame.bound) : TeTable::Cell(),
                    isDrawn ? TeTable::Cell(frame.triangles) : TeTable::Cell()});
    }
  return table;
}

TeTable TeQualityCommand::summaryOf(const std::vector<TeQualityTrace>& traces) {
  TeTable table({"run", "load", "seconds to within 10 %", "then frame / goal (median)", "then turns"});
  for (const TeQualityTrace& trace : traces)
    for (const TeQualityTrace::Step& step : trace.steps) {
      const std::optional<double> returned = trace.returned(step);
      table.addRow({trace.name, step.load, returned ? TeTable::Cell(*returned) : TeTable::Cell(),
                    trace.settledCost(step), std::int64_t(trace.turns(step))});
    }
  return table;
}

void TeQualityCommand::addPlots(const TeQualityTrace& trace, const std::string& suffix,
                                TeAccuracyOutput& output) {
  TePlot times, errors;
  times.title = "Frame time under load steps, " + trace.name;
  errors.title = "Error under load steps, " + trace.name;
  times.xLabel = errors.xLabel = "time [s]";
  times.yLabel = "drawing a frame [ms]";
  errors.yLabel = "error on the screen [pixels]";
  times.logX = times.logY = errors.logX = false;
  times.markers = errors.markers = false;
  TePlot::Curve cost{"frame", {}, {}}, goal{"goal", {}, {}}, low{"goal - 10 %", {}, {}},
      high{"goal + 10 %", {}, {}};
  TePlot::Curve wanted{"wanted", {}, {}}, bound{"bound of what was drawn", {}, {}},
      load{"load (factor)", {}, {}};
  for (const TeQualityTrace::Frame& frame : trace.frames) {
    for (TePlot::Curve* curve : {&cost, &goal, &low, &high, &wanted, &bound, &load})
      curve->x.push_back(frame.time);
    cost.y.push_back(1000 * frame.seconds);
    goal.y.push_back(1000 * trace.goal);
    low.y.push_back(900 * trace.goal);
    high.y.push_back(1100 * trace.goal);
    wanted.y.push_back(frame.pixelError);
    bound.y.push_back(frame.bound); // 0, not known, is no point of a logarithm
    load.y.push_back(frame.load);
  }
  times.curves = {cost, goal, low, high};
  errors.curves = {wanted, bound, load};
  output.addPlot(times, suffix + "_time");
  output.addPlot(errors, suffix + "_error");
}

TeResult<TeTable> TeQualityCommand::measure(TeAccuracyOutput& output) {
  const TeResult<std::vector<TeQualityTrace>> traces = this->traces(output);
  if (!traces)
    return traces.error();
  const TeTable summary = summaryOf(*traces);
  output.json()["steps"] = summary.json();
  output.addTable(summary);
  for (const TeQualityTrace& trace : *traces)
    if (std::find(shownRuns().begin(), shownRuns().end(), trace.name) != shownRuns().end())
      addPlots(trace, trace.name.substr(0, trace.name.find(',')), output);
  return tableOf(*traces);
}
