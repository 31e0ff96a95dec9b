#include "apps/terrane-accuracy/TeNormalsCommand.h"

#include "apps/common/TeExit.h"
#include "apps/common/TeProgressLine.h"
#include "apps/terrane-accuracy/TeSmoothLand.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <cstdio>
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
    : m_commandLine(commandLine),
      m_cli(commandLine.cli().add_subcommand(
          "normals", "Measures angle errors of normals against time, by way and level")) {
  m_cli->fallthrough();
  m_terrain.addTo(*m_cli);
  const std::string group = "Measuring";
  m_cli->add_option("--samples-log", m_samplesLog, "Look at the middle 2^N + 1 samples a side (default: 9)")
      ->transform(TeCommandLine::wholeWithin(4, 12))
      ->option_text("N")
      ->group(group);
  m_cli->add_option("--levels", m_levels, "Levels, 0 being that of all samples (default: 6)")
      ->transform(TeCommandLine::wholeWithin(1, 10))
      ->option_text("N")
      ->group(group);
  m_cli->add_option("--runs", m_runs, "Times that each is timed (default: 9)")
      ->transform(TeCommandLine::wholeWithin(1, 1000))
      ->option_text("N")
      ->group(group);
  m_cli->add_option("--out", m_folder, "Folder for what is written (default: accuracy)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("DIR")
      ->group(group);
}

TeResult<TeHeightMap> TeNormalsCommand::land(std::string& name, double& spacing) const {
  const int samples = (1 << m_samplesLog) + 1;
  if (m_terrain.map.empty() && m_terrain.dem.empty()) {
    name = "mountains";
    spacing = TeSmoothLand::kSpacing;
    return teMountains(samples);
  }
  const TeResult<TeMeasuredTerrain> terrain = m_terrain.read();
  if (!terrain)
    return terrain.error();
  name = std::filesystem::path(terrain->name).filename().string();
  spacing = terrain->spacing();
  const int side = std::min(samples, terrain->heights().width());
  const int first = (terrain->heights().width() - side) / 2;
  TeResult<TeHeightMap> map = TeHeightMap::create(side, side);
  if (map)
    if (const TeStatus ok = map->addScaled(terrain->heights(), float(terrain->heightScale()),
                                           {first, first, side, side}, map->bounds());
        !ok)
      return ok.error();
  return map;
}

void TeNormalsCommand::measure(const TeNormalsTerrain& terrain, TeTable& table, std::string& words,
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

int TeNormalsCommand::run() {
  const std::string& application = m_commandLine.application();
  const bool quiet = m_commandLine.common().quiet;
  TeAccuracyOutput output(m_commandLine, "normals", m_folder);
  std::string name;
  double spacing = 1;
  const TeResult<TeHeightMap> map = land(name, spacing);
  if (!map)
    return teExitWith(TeExitUsage, application, map.error().message);
  if (const TeStatus ok = output.prepare(); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);

  TeTable table({"terrain", "way", "level", "data", "vertices", "ns", "low_ns", "high_ns", "ratio",
                 "vertex_mean_deg", "vertex_max_deg", "mean_deg", "max_deg"});
  const TeSmoothLand formula;
  const TeHeightMap smooth = formula.heights((1 << m_samplesLog) + 1);
  std::string words;
  Plots plots;
  {
    TeProgressLine progress("Measuring normals", quiet);
    measure({"formula", "against its derivatives", &smooth, TeSmoothLand::kSpacing,
             [&](int column, int row) { return formula.normal(column, row); }},
            table, words, plots);
    progress.update(0.5);
    measure(
        {name, "against the angle-weighted mean of the six triangles at a sample", &*map, spacing,
         [&](int column, int row) { return teNormalBy(TeNormalWay::Angle, *map, column, row, 1, spacing); }},
        table, words, plots);
  }
  output.json()["terrain"] = {{"name", name}, {"samples", map->width()}, {"spacing_m", spacing}};
  output.addText(
      teFormat("%d² samples. Level L has a vertex every 2^L samples. `data`: normals from all samples "
               "(`fine`, what the engine carries to coarse levels) or from the level's own vertices. "
               "`vertex_*`: angles from the true normal at the vertices; the others at all samples, "
               "normals between vertices interpolated as when they are drawn.",
               map->width()));
  output.addText(words);
  for (const auto& [suffix, plot] : plots)
    output.addPlot(plot, suffix);
  output.addTable(table);
  if (!quiet)
    std::fputs(table.markdown().c_str(), stdout);
  if (const TeStatus ok = output.write(table); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  return TeExitSuccess;
}
