#include "apps/terrane-accuracy/TeGenerationCommand.h"

#include "apps/common/TeProgressLine.h"
#include "generators/base/TeText.h"

#include <algorithm>

namespace {

const std::vector<std::string> kGenerators = {"faults", "circles", "midpoint", "noise", "band"};

bool isArithmetic(const TeGenerationFigures& figures) { return figures.dial == "arithmetic"; }

/// Curves of all dials; `error` gives none for those that are not to be drawn.
template <class Error>
TePlot plotOf(const std::vector<TeGenerationFigures>& all, const std::string& title, const std::string& label,
              Error error) {
  TePlot plot{title, "CPU time of a map, ms (median)", label, true, true, {}};
  for (const TeGenerationFigures& figures : all) {
    const std::optional<double> value = error(figures);
    if (!value || figures.isReference || isArithmetic(figures))
      continue;
    const std::string name = figures.generator + ", " + figures.dial;
    if (plot.curves.empty() || plot.curves.back().name != name)
      plot.curves.push_back({name, {}, {}});
    plot.curves.back().x.push_back(figures.ms.median);
    plot.curves.back().y.push_back(*value);
  }
  return plot;
}

/// What the first, the document's and the last value of each dial come to, in words.
std::string wordsOf(const std::vector<TeGenerationFigures>& all) {
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const TeGenerationFigures& first = all[i];
    if (isArithmetic(first) || (i > 0 && all[i - 1].generator == first.generator))
      continue;
    std::size_t last = i;
    while (last + 1 < all.size() && all[last + 1].generator == first.generator &&
           !isArithmetic(all[last + 1]))
      ++last;
    const TeGenerationFigures& end = all[last > i ? last - 1 : last]; // the reference has no error
    text += teFormat("* **%s**: from %g to %g %s a map takes %.3g to %.3g ms", first.generator.c_str(),
                     first.value, end.value, first.dial.c_str(), first.ms.median, end.ms.median);
    if (first.rms)
      text += teFormat(", its error falls from %.3g %% to %.3g %% of the relief", 100 * *first.rms,
                       100 * *end.rms);
    text += teFormat(", and its spectrum from %.3g to %.3g dB off.", *first.spectrumDecibels,
                     *end.spectrumDecibels);
    // Tenfold accuracy by the slope of the ends in logarithms.
    const double better = first.rms ? *first.rms / std::max(*end.rms, 1e-30)
                                    : *first.spectrumDecibels / std::max(*end.spectrumDecibels, 1e-30);
    if (better > 3)
      text += teFormat(" A tenth of the error costs %.3g times the time, on the whole.",
                       std::pow(end.ms.median / first.ms.median, 1 / std::log10(better)));
    text += "\n";
  }
  for (const TeGenerationFigures& figures : all)
    if (isArithmetic(figures) && !figures.inDouble)
      text += teFormat("* **%s** in single precision or whole numbers: at most %.2g of the relief from the "
                       "plain formula in double precision, in %.3g of its time.\n",
                       figures.generator.c_str(), figures.worst.value_or(0), figures.ratio);
  return text;
}

} // namespace

TeGenerationCommand::TeGenerationCommand(TeCommandLine& commandLine)
    : TeAccuracyCommand(commandLine, "generation",
                        "Measures what better maps cost: faults, iterations, levels, octaves, passes") {
  addList("--generators", m_generators, CLI::IsMember(kGenerators),
          "faults, circles, midpoint, noise, band (default: all)");
  addInteger("--samples-log", m_samplesLog, 4, 11, "Maps of 2^N + 1 samples a side (default: 8)");
  addInteger("--maps", m_effort.maps, 1, 1000, "Maps that errors are measured over (default: 4)");
  addInteger("--runs", m_effort.runs, 1, 1000, "Times that each map is timed (default: 9)");
  addOutput();
}

void TeGenerationCommand::addRow(const TeGenerationFigures& figures, TeTable& table) {
  using Cell = TeTable::Cell;
  const auto maybe = [](const std::optional<double>& value) { return value ? Cell(*value) : Cell(); };
  table.addRow(
      {figures.generator, figures.dial, figures.value, std::string(figures.inDouble ? "double" : "ours"),
       std::string(figures.isReference ? "yes" : "no"), figures.ms.median, figures.ms.low, figures.ms.high,
       figures.ratio, maybe(figures.rms), maybe(figures.worst), maybe(figures.spectrumDecibels)});
}

void TeGenerationCommand::describe(const std::vector<TeGenerationFigures>& figures, const TeTable& table,
                                   TeAccuracyOutput& output) const {
  output.json()["maps"] = {{"samples", m_effort.samples}, {"maps", m_effort.maps}, {"runs", m_effort.runs}};
  output.addText(teFormat(
      "Maps of %d² samples, 1 m apart, %d of each value, timed %d times each. The reference is the dial's "
      "last value: more faults of ever smaller amounts, more octaves of ever smaller weight, all levels, "
      "many "
      "weak passes with the same blur. Errors are those of heights, as parts of the reference's relief, and "
      "of the radially averaged spectrum (each octave's share of the power, RMS over the octaves in dB); "
      "circles do not come nearer to any heights, only to a spectrum.",
      m_effort.samples, m_effort.maps, m_effort.runs));
  output.addText(wordsOf(figures));
  output.addPlot(plotOf(figures, "Generating: error of heights against time", "RMS error, part of the relief",
                        [](const TeGenerationFigures& f) { return f.rms; }),
                 "heights");
  output.addPlot(plotOf(figures, "Generating: error of the spectrum against time",
                        "error of the spectrum, dB",
                        [](const TeGenerationFigures& f) { return f.spectrumDecibels; }),
                 "spectrum");
  output.addTable(table);
}

TeResult<TeTable> TeGenerationCommand::measure(TeAccuracyOutput& output) {
  m_effort.samples = (1 << m_samplesLog) + 1;
  TeTable table({"generator", "dial", "value", "arithmetic", "reference", "ms", "low_ms", "high_ms", "ratio",
                 "rms_of_relief", "worst_of_relief", "spectrum_db"});
  std::vector<TeGenerationFigures> all;
  {
    TeProgressLine progress("Generating", common().quiet);
    const std::vector<TeGenerationDial> dials = teGenerationDials(m_effort.samples);
    for (std::size_t i = 0; i < dials.size(); ++i) {
      progress.update(double(i) / double(dials.size()));
      if (!m_generators.empty() &&
          std::find(m_generators.begin(), m_generators.end(), dials[i].generator) == m_generators.end())
        continue;
      for (TeGenerationFigures& figures : teMeasureGeneration(dials[i], m_effort)) {
        addRow(figures, table);
        all.push_back(std::move(figures));
      }
    }
  }
  describe(all, table, output);
  return table;
}
