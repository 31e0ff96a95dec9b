#include "apps/terrane-accuracy/TeNormalsCommand.h"

#include "apps/common/TeProgressLine.h"
#include "apps/terrane-accuracy/TeSmoothLand.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <filesystem>

namespace {

const char* nameOfData(bool fromFine) { return fromFine ? "fine" : "level"; }

/// Error over all samples against the time of a vertex: a curve for each way and data, a point for each
/// level.
TePlot byTime(const std::vector<TeNormalsFigures>& all, const TeNormalsTerrain& terrain) {
  TePlot plot{"Normals of level 0: error against time, " + terrain.name,
              "CPU time of a vertex, ns (median)",
              "mean angle at the vertices, degrees",
              true,
              true,
              {}};
  for (const TeNormalsFigures& figures : all)
    if (figures.level == 0)
      plot.curves.push_back({teNameOf(figures.way), {figures.ns.median}, {figures.meanAtVertices}});
  return plot;
}

TePlot byLevel(const std::vector<TeNormalsFigures>& all, const TeNormalsTerrain& terrain) {
  TePlot plot{"Normals at coarse levels, " + terrain.name,
              "samples between vertices",
              "mean angle over all samples, degrees",
              true,
              true,
              {}};
  for (const TeNormalWay way : {TeNormalWay::Central, TeNormalWay::Area})
    for (const bool fromFine : {true, false}) {
      TePlot::Curve curve{
          std::string(teNameOf(way)) + " of " + (fromFine ? "all samples" : "the level's"), {}, {}};
      for (const TeNormalsFigures& figures : all)
        if (figures.way == way && (figures.fromFine == fromFine || figures.level == 0)) {
          curve.x.push_back(1 << figures.level);
          curve.y.push_back(figures.mean);
        }
      plot.curves.push_back(std::move(curve));
    }
  return plot;
}

std::string wordsOf(const std::vector<TeNormalsFigures>& all, const TeNormalsTerrain& terrain) {
  const auto at = [&](TeNormalWay way, int level, bool fromFine) {
    return *std::find_if(all.begin(), all.end(), [&](const TeNormalsFigures& f) {
      return f.way == way && f.level == level && f.fromFine == fromFine;
    });
  };
  const TeNormalsFigures central = at(TeNormalWay::Central, 0, true);
  std::string text = teFormat(
      "* **%s** (%s): central differences are %.3g° off in the mean, at most %.3g°, in %.3g ns a vertex",
      terrain.name.c_str(), terrain.reference.c_str(), central.meanAtVertices, central.worstAtVertices,
      central.ns.median);
  for (const TeNormalWay way : {TeNormalWay::Area, TeNormalWay::Angle, TeNormalWay::Face}) {
    const TeNormalsFigures other = at(way, 0, true);
    text += teFormat("; %s %.3g°, at most %.3g°, in %.3g times the time", teNameOf(way), other.meanAtVertices,
                     other.worstAtVertices, other.ratio);
  }
  const int last = all.back().level;
  if (last > 0) {
    const TeNormalsFigures fine = at(TeNormalWay::Central, last, true);
    const TeNormalsFigures coarse = at(TeNormalWay::Central, last, false);
    text +=
        teFormat(". With a vertex every %d samples, normals of all samples are %.3g° off at the vertices and "
                 "%.3g° over all samples; of the level's own %.3g° and %.3g°",
                 1 << last, fine.meanAtVertices, fine.mean, coarse.meanAtVertices, coarse.mean);
  }
  return text + ".\n";
}

} // namespace

TeNormalsCommand::TeNormalsCommand(TeCommandLine& commandLine)
    : TeAccuracyCommand(commandLine, "normals",
                        "Measures angle errors of normals against time, by way and level") {
  m_choice.addTo(cli());
  addInteger("--samples-log", m_samplesLog, 4, 12, "Look at the middle 2^N + 1 samples a side (default: 9)");
  addInteger("--levels", m_levels, 1, 10, "Levels, 0 being that of all samples (default: 6)");
  addInteger("--runs", m_runs, 1, 1000, "Times that each is timed (default: 9)");
  addOutput();
}

TeStatus TeNormalsCommand::read() {
  const TeResult<TeMeasuredTerrain> terrain = m_choice.readOrMountains(samples());
  if (!terrain)
    return terrain.error();
  m_name = std::filesystem::path(terrain->name).filename().string();
  m_spacing = terrain->spacing();
  const TeMapRect middle = terrain->middle(samples());
  if (const TeStatus ok = keep(TeHeightMap::create(middle.width, middle.height), m_map); !ok)
    return ok;
  return m_map->addScaled(terrain->heights(), float(terrain->heightScale()), middle, m_map->bounds());
}

void TeNormalsCommand::measureOn(const TeNormalsTerrain& terrain, TeTable& table, std::string& words,
                                 Plots& plots) const {
  const std::vector<TeNormalsFigures> all = teMeasureNormals(terrain, m_levels, m_runs);
  for (const TeNormalsFigures& figures : all)
    table.addRow({terrain.name, std::string(teNameOf(figures.way)), std::int64_t(figures.level),
                  std::string(nameOfData(figures.fromFine)), figures.vertices, figures.ns.median,
                  figures.ns.low, figures.ns.high, figures.ratio, figures.meanAtVertices,
                  figures.worstAtVertices, figures.mean, figures.worst});
  words += wordsOf(all, terrain);
  const std::string suffix = terrain.name == "formula" ? "formula" : "land";
  plots.push_back({suffix + "_time", byTime(all, terrain)});
  plots.push_back({suffix + "_levels", byLevel(all, terrain)});
}

TeResult<TeTable> TeNormalsCommand::measure(TeAccuracyOutput& output) {
  TeTable table({"terrain", "way", "level", "data", "vertices", "ns", "low_ns", "high_ns", "ratio",
                 "vertex_mean_deg", "vertex_max_deg", "mean_deg", "max_deg"});
  const TeSmoothLand formula;
  const TeHeightMap smooth = formula.heights(samples());
  std::string words;
  Plots plots;
  {
    TeProgressLine progress("Measuring normals", common().quiet);
    measureOn({"formula", "against its derivatives", &smooth, TeSmoothLand::kSpacing,
               [&](int column, int row) { return formula.normal(column, row); }},
              table, words, plots);
    progress.update(0.5);
    measureOn({m_name, "against the angle-weighted mean of the six triangles at a sample", &*m_map, m_spacing,
               [&](int column, int row) {
                 return teNormalBy(TeNormalWay::Angle, *m_map, column, row, 1, m_spacing);
               }},
              table, words, plots);
  }
  output.json()["terrain"] = {{"name", m_name}, {"samples", m_map->width()}, {"spacing_m", m_spacing}};
  output.addText(
      teFormat("%d² samples. Level L has a vertex every 2^L samples. `data`: normals from all samples "
               "(`fine`, what the engine carries to coarse levels) or from the level's own vertices. "
               "`vertex_*`: angles from the true normal at the vertices; the others at all samples, "
               "normals between vertices interpolated as when they are drawn.",
               m_map->width()));
  output.addText(words);
  for (const auto& [suffix, plot] : plots)
    output.addPlot(plot, suffix);
  output.addTable(table);
  return table;
}
