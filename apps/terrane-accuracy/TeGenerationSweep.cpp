#include "apps/terrane-accuracy/TeGenerationSweep.h"

#include "apps/terrane-accuracy/TePlainGenerators.h"
#include "apps/terrane-accuracy/TeRadialSpectrum.h"
#include "generators/base/TeAllowance.h"

#include <algorithm>
#include <cmath>

namespace {

/// Differences of maps, each in shares of the reference's relief.
class Differences {
public:
  void add(const TeHeightMap& map, const TeDoubleHeights& reference) {
    const auto [low, high] = std::minmax_element(reference.begin(), reference.end());
    const double relief = *high - *low;
    for (std::size_t i = 0; i < reference.size() && relief > 0; ++i) {
      const double share = std::fabs(map.data()[i] - reference[i]) / relief;
      m_squares += share * share;
      m_worst = std::max(m_worst, share);
    }
    m_count += reference.size();
  }
  double rms() const { return std::sqrt(m_squares / double(m_count)); }
  double worst() const { return m_worst; }

private:
  double m_squares = 0;
  double m_worst = 0;
  std::size_t m_count = 0;
};

/// Times several works in turn, so that what disturbs one mostly disturbs all: milliseconds by work, then
/// run.
std::vector<std::vector<double>> timeInTurn(const std::vector<std::function<void()>>& works, int runs) {
  std::vector<std::vector<double>> ms(works.size());
  for (const std::function<void()>& work : works)
    work(); // fills the caches
  for (int run = 0; run < runs; ++run)
    for (std::size_t i = 0; i < works.size(); ++i) {
      const double start = teThreadCpuSeconds();
      works[i]();
      ms[i].push_back(1e3 * (teThreadCpuSeconds() - start));
    }
  return ms;
}

void setTimes(const std::vector<double>& ms, const std::vector<double>& reference,
              TeGenerationFigures& figures) {
  figures.ms = TeSpread::of(ms);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < ms.size(); ++i)
    ratios.push_back(ms[i] / std::max(reference[i], 1e-9));
  figures.ratio = TeSpread::of(ratios).median;
}

void measureArithmetic(const TeGenerationDial& dial, const TeGenerationEffort& effort,
                       std::vector<TeGenerationFigures>& all) {
  const TeGenerationDial::Arithmetic& arithmetic = dial.arithmetic;
  Differences differences;
  for (int map = 0; map < effort.maps; ++map)
    differences.add(dial.make(arithmetic.value, std::uint64_t(map)), arithmetic.inDouble(std::uint64_t(map)));
  const auto ours = [&] {
    dial.work ? dial.work(arithmetic.value, 0) : void(dial.make(arithmetic.value, 0));
  };
  const auto plain = [&] { arithmetic.work ? arithmetic.work() : void(arithmetic.inDouble(0)); };
  const std::vector<std::vector<double>> ms = timeInTurn({ours, plain}, effort.runs);
  for (const bool inDouble : {false, true}) {
    TeGenerationFigures figures;
    figures.generator = dial.generator;
    figures.dial = "arithmetic";
    figures.value = arithmetic.value;
    figures.inDouble = figures.isReference = inDouble;
    figures.rms = inDouble ? 0 : differences.rms();
    figures.worst = inDouble ? 0 : differences.worst();
    setTimes(ms[inDouble ? 1 : 0], ms[1], figures);
    all.push_back(std::move(figures));
  }
}

} // namespace

std::vector<TeGenerationFigures> teMeasureGeneration(const TeGenerationDial& dial,
                                                     const TeGenerationEffort& effort) {
  std::vector<double> values = dial.values;
  values.push_back(dial.reference);
  std::vector<Differences> differences(values.size());
  std::vector<TeRadialSpectrum> spectra(values.size(), TeRadialSpectrum(effort.samples - 1));
  for (int map = 0; map < effort.maps; ++map) {
    const TeHeightMap converged = dial.make(dial.reference, std::uint64_t(map));
    const TeDoubleHeights reference = teInDouble(converged);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const TeHeightMap heights =
          values[i] == dial.reference ? converged : dial.make(values[i], std::uint64_t(map));
      differences[i].add(heights, reference);
      spectra[i].add(heights);
    }
  }
  std::vector<std::function<void()>> works;
  for (const double value : values)
    works.push_back([&dial, value] { dial.work ? dial.work(value, 0) : void(dial.make(value, 0)); });
  const std::vector<std::vector<double>> ms = timeInTurn(works, effort.runs);

  std::vector<TeGenerationFigures> all;
  const std::vector<double> reference = spectra.back().shares();
  for (std::size_t i = 0; i < values.size(); ++i) {
    TeGenerationFigures figures;
    figures.generator = dial.generator;
    figures.dial = dial.name;
    figures.value = values[i];
    figures.isReference = values[i] == dial.reference;
    if (dial.converges) {
      figures.rms = differences[i].rms();
      figures.worst = differences[i].worst();
    }
    figures.spectrumDecibels = TeRadialSpectrum::difference(spectra[i].shares(), reference);
    setTimes(ms[i], ms.back(), figures);
    all.push_back(std::move(figures));
  }
  if (dial.arithmetic.inDouble)
    measureArithmetic(dial, effort, all);
  return all;
}
