#include "apps/terrane-accuracy/TeHeightCommand.h"

#include "apps/common/TeProgressLine.h"
#include "generators/base/TeText.h"

#include <filesystem>

namespace {

/// Without level 0, which has no error but that of rounding.
TePlot errorPlot(const std::vector<TeHeightFigures>& all) {
  TePlot plot{"Heights by level: error against time",
              "CPU time of a query, ns (median)",
              "RMS difference from level 0, metres",
              true,
              true,
              {}};
  for (const TeHeightQuery query : kTeHeightQueries) {
    if (query == TeHeightQuery::Together)
      continue; // of level 0 only
    TePlot::Curve curve{teNameOf(query), {}, {}};
    for (const TeHeightFigures& figures : all)
      if (figures.query == query && figures.level > 0) {
        curve.x.push_back(figures.ns.median);
        curve.y.push_back(figures.rms);
      }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

TePlot memoryPlot(const std::vector<TeHeightFigures>& all, const TeHeightWorld& world) {
  TePlot plot{"Heights by level: error against memory",
              "bytes for a sample of level 0",
              "difference from level 0, metres",
              true,
              true,
              {}};
  TePlot::Curve rms{"RMS", {}, {}}, worst{"largest", {}, {}}, bound{"what queries say (mean)", {}, {}};
  for (const TeHeightFigures& figures : all)
    if (figures.query == TeHeightQuery::Scattered) {
      const double bytes = world.bytesPerSample(figures.level);
      for (auto& [curve, value] :
           {std::pair(&rms, figures.rms), {&worst, figures.worst}, {&bound, figures.bound}}) {
        curve->x.push_back(bytes);
        curve->y.push_back(value);
      }
    }
  plot.curves = {rms, worst, bound};
  return plot;
}

std::string wordsOf(const std::vector<TeHeightFigures>& all, const TeHeightWorld& world) {
  std::string text;
  std::int64_t over = 0;
  for (const TeHeightFigures& figures : all)
    over += figures.over;
  for (const TeHeightQuery query : kTeHeightQueries) {
    const TeHeightFigures *first = nullptr, *last = nullptr;
    for (const TeHeightFigures& figures : all)
      if (figures.query == query) {
        first = first ? first : &figures;
        last = &figures;
      }
    if (query == TeHeightQuery::Ray)
      text += teFormat("* **%s**: %.3g million a second at level 0", teNameOf(query), 1e3 / first->ns.median);
    else
      text += teFormat("* **%s**: %.3g ns at level 0", teNameOf(query), first->ns.median);
    if (last != first)
      text += teFormat("; at level %d %.3g ns, with an error of %.3g m (RMS), at most %.3g m", last->level,
                       last->ns.median, last->rms, last->worst);
    text += ".\n";
  }
  text += teFormat("* Level 0 takes %.3g bytes a sample", world.bytesPerSample(0));
  if (world.levels() > 1)
    text += teFormat(", level %d %.3g; of %lld answers of all levels %lld were farther off than they said",
                     world.levels() - 1, world.bytesPerSample(world.levels() - 1),
                     static_cast<long long>(std::int64_t(all.size()) * all.front().queries),
                     static_cast<long long>(over));
  return text + ".\n";
}

} // namespace

TeHeightCommand::TeHeightCommand(TeCommandLine& commandLine)
    : TeAccuracyCommand(commandLine, "height",
                        "Measures heights and rays by level: errors, time and memory") {
  m_choice.addTo(cli());
  addInteger("--samples-log", m_samplesLog, 5, 12,
             "Mountains of 2^N + 1 samples a side if no file is given (default: 11)");
  addInteger("--levels", m_levels, 1, 9, "Levels, as many as fit (default: 7)");
  addInteger("--queries", m_queries, 1, 10000000, "Queries of each kind and level (default: 20000)");
  addInteger("--runs", m_runs, 1, 1000, "Times that they are timed (default: 9)");
  addOutput();
}

TeStatus TeHeightCommand::read() {
  if (const TeStatus ok = keep(m_choice.readOrMountains((1 << m_samplesLog) + 1), m_terrain); !ok)
    return ok;
  TeProgressLine progress("Making levels", common().quiet);
  return keep(TeHeightWorld::create(*m_terrain, m_levels, [&](double done) { progress.update(done); }),
              m_world);
}

void TeHeightCommand::describe(const std::vector<TeHeightFigures>& all, const TeTable& table,
                               TeAccuracyOutput& output) const {
  const TeMeasuredTerrain& terrain = *m_terrain;
  output.json()["terrain"] = {{"name", std::filesystem::path(terrain.name).filename().string()},
                              {"samples", terrain.cells() + 1},
                              {"spacing_m", terrain.spacing()},
                              {"height_unit_m", terrain.heightScale()}};
  output.addText(teFormat(
      "%d² samples, %g m apart, in patches of %d² cells and coarser ones of every 2^L-th "
      "sample. %d queries of each "
      "kind: heights along a walk, anywhere and there in one call, and rays from 150 m above the ground, "
      "14° to 45° down. Errors are "
      "differences from level 0, of rays that of the heights where they hit; `bound_m` "
      "is what the answers say of "
      "themselves, in the mean, and `over` counts those that were farther off.",
      terrain.cells() + 1, terrain.spacing(), TeHeightWorld::kCells, m_queries));
  output.addText(wordsOf(all, *m_world));
  output.addPlot(errorPlot(all), "time");
  output.addPlot(memoryPlot(all, *m_world), "memory");
  output.addTable(table);
}

TeResult<TeTable> TeHeightCommand::measure(TeAccuracyOutput& output) {
  TeTable table({"query", "level", "queries", "ns", "low_ns", "high_ns", "ratio", "rms_m", "max_m", "bound_m",
                 "worst_bound_m", "over", "missed", "bytes_per_sample"});
  const std::vector<TeHeightFigures> all = teMeasureHeights(*m_world, m_queries, m_runs);
  for (const TeHeightFigures& figures : all)
    table.addRow({std::string(teNameOf(figures.query)), std::int64_t(figures.level), figures.queries,
                  figures.ns.median, figures.ns.low, figures.ns.high, figures.ratio, figures.rms,
                  figures.worst, figures.bound, m_world->worstDeviation(figures.level), figures.over,
                  figures.missed, m_world->bytesPerSample(figures.level)});
  describe(all, table, output);
  return table;
}
