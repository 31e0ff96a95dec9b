#include "apps/terrane-accuracy/TeLodRun.h"

#include "apps/terrane-accuracy/TeLodVerdict.h"
#include "generators/base/TeText.h"
#include "nodes/lod/TeLodMethods.h"

#include <algorithm>

namespace {

constexpr std::int64_t kMaxTriangles = std::int64_t(1) << 28;

bool isFor(const TeLodSettings::Dial& dial, const TeLodCandidate& candidate) {
  return dial.method.empty() ? candidate.hasDial() : dial.method == candidate.name();
}

} // namespace

TeResult<TeLodRun> TeLodRun::create(TeMeasuredTerrain terrain, const TeLodSettings& settings) {
  TeLodRun run(std::move(terrain), settings);
  if (const TeStatus ok = run.addCandidates(); !ok)
    return ok.error();
  if (const TeStatus ok = run.checkDials(); !ok)
    return ok.error();
  return run;
}

TeStatus TeLodRun::addCandidates() {
  const std::vector<std::string>& methods =
      m_settings.methods.empty() ? TeLodMethods::names() : m_settings.methods;
  const auto add = [&](const std::string& name, const std::string& layout) -> TeStatus {
    TeResult<TeLodCandidate> candidate = TeLodCandidate::create(name, layout, m_terrain.field);
    if (!candidate)
      return candidate.error();
    m_candidates.push_back(std::move(*candidate));
    return {};
  };
  for (const std::string& method : methods)
    for (const std::string& layout : m_settings.layouts) {
      if (const TeStatus ok = add(method, layout); !ok)
        return ok;
      const TeLodCandidate& plain = m_candidates.back();
      const bool hasLayout = !plain.layout().empty();
      if (m_settings.geomorph && !plain.geomorph() && plain.method().morphs())
        if (const TeStatus ok = add(TeLodCandidate::morphedName(method), layout); !ok)
          return ok;
      if (!hasLayout)
        break;
    }
  return {};
}

TeStatus TeLodRun::checkDials() const {
  for (const TeLodSettings::Dial& dial : m_settings.dials) {
    bool isUsed = false;
    for (const TeLodCandidate& candidate : m_candidates) {
      if (!isFor(dial, candidate))
        continue;
      const TeLodDial& range = candidate.method().dial();
      if (range.name.empty())
        return TeError{"dial of " + dial.method + ": it has none"};
      if (!(dial.value >= range.least && dial.value <= range.most))
        return TeError{teFormat("dial %g of %s: %s from %g to %g", dial.value, candidate.name().c_str(),
                                range.name.c_str(), range.least, range.most)};
      isUsed = true;
    }
    if (!isUsed)
      return TeError{"dial of " + (dial.method.empty() ? "all" : dial.method) +
                     ": no such method is measured"};
  }
  return {};
}

TeFlyover TeLodRun::flight() const {
  TeFlyover flight = m_terrain.flyover();
  flight.width = m_settings.width;
  flight.height = m_settings.height;
  return flight;
}

std::vector<TeLodAccuracy> TeLodRun::accuracies(const TeLodCandidate& candidate) const {
  TeLodAccuracy accuracy;
  accuracy.maxTriangles = kMaxTriangles;
  accuracy.pixelError = 0;
  if (!candidate.hasDial())
    return {accuracy};
  std::vector<TeLodAccuracy> all;
  for (const double pixels : m_settings.pixels) {
    accuracy.pixelError = pixels;
    all.push_back(accuracy);
  }
  for (const TeLodSettings::Dial& dial : m_settings.dials)
    if (isFor(dial, candidate)) {
      accuracy.dial = dial.value;
      all.push_back(accuracy);
    }
  return all;
}

TeStatus TeLodRun::measure(TeFlightStage* stage, const std::function<void(double)>& progress) {
  const TeFlyover flight = this->flight();
  m_renderer = stage ? stage->context().renderer() : std::string();
  const int frames = m_settings.frames.count;
  double total = 0, done = 0;
  for (const TeLodCandidate& candidate : m_candidates)
    total += double(accuracies(candidate).size()) * frames;
  for (TeLodCandidate& candidate : m_candidates)
    for (const TeLodAccuracy& accuracy : accuracies(candidate)) {
      const TeLodFigures figures = teMeasureLod(candidate, accuracy, m_terrain, flight, m_settings.frames,
                                                [&](int frame) { progress((done + frame) / total); });
      done += frames;
      std::optional<TeFrameFigures> drawn;
      if (stage) {
        TeResult<TeFrameFigures> result =
            teMeasureFrames(candidate, accuracy, m_terrain, flight, m_settings.frames, *stage);
        if (!result)
          return result.error();
        drawn = *result;
      }
      m_table.add(candidate, accuracy, frames, figures, drawn);
    }
  return {};
}

void TeLodRun::describe(TeAccuracyOutput& output) const {
  const TeFlyover flight = this->flight();
  const TeMeasuredFrames& frames = m_settings.frames;
  auto& json = output.json();
  json["terrain"] = {{"file", m_terrain.name},
                     {"samples", m_terrain.cells() + 1},
                     {"spacing_m", m_terrain.spacing()},
                     {"height_unit_m", m_terrain.heightScale()}};
  json["flight"] = {{"frames", frames.count},
                    {"degrees_a_frame", flight.anglePerFrame * frames.stride},
                    {"width", flight.width},
                    {"height", flight.height}};
  if (!m_renderer.empty())
    json["renderer"] = m_renderer;
  output.addText(
      teFormat("%d² samples, %g m apart; %d frames of the flyover, %g degrees each; %d×%d pixels. ",
               m_terrain.cells() + 1, m_terrain.spacing(), frames.count, flight.anglePerFrame * frames.stride,
               flight.width, flight.height) +
      (m_renderer.empty() ? std::string("Not drawn.") : "Drawn by " + m_renderer + "."));
  for (const std::string& paragraph : TeLodVerdict(m_table.table()).paragraphs())
    output.addText(paragraph);
  output.addPlot(m_table.plot("Error against triangles", "triangles", "triangles of a frame (mean)"),
                 "triangles");
  output.addPlot(
      m_table.plot("Error against time of selection", "select_ms", "selection, ms of CPU time (median)"),
      "selection");
  if (!m_renderer.empty())
    output.addPlot(m_table.plot("Error against frame time", "frame_ms", "frame, ms (median)"), "frame");
  output.addTable(m_table.table());
}
