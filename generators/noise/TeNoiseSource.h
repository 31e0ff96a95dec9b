#pragma once

#include "generators/TeHeightSource.h"
#include "generators/noise/TeNoiseKernel.h"
#include "generators/noise/TeNoiseSettings.h"

/// Gradient noise as a source: fits() and pointEvaluable(). A height depends on the settings, the world seed,
/// the spacing and the sample's distance from the world's origin in half cells, and on nothing else; that
/// distance enters as an integer, so detail 10^12 m out is as fine as at the origin.
///
/// The same bits on every processor, for every tiling and for scattered points. The height is the float
/// nearest to the formulas of TeNoisePlan.h in exact arithmetic, or the one next to it, as long as it is
/// larger than 10^-7 of the amplitude; below, the error is at most 10^-14 of the amplitude.
///
/// Cost, 8 octaves: docs/gradient-noise.md.
class TeNoiseSource final : public TePointSource {
public:
  /// Error: settings out of range. The kernel is for tests and benchmarks; it must outlive the source.
  static TeResult<TeHeightSourcePtr> create(const TeNoiseSettings& settings,
                                            const TeNoiseKernel& kernel = TeNoiseKernel::best());

  std::string name() const override { return "noise"; }
  std::uint64_t fingerprint() const override;
  bool fits() const override { return true; }

  std::unique_ptr<TeHeightJob> start(const TeMapRequest& request) const override;
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override;
  TeStatus evaluateRun(const TeMapRequest& request, TeMapSample first, int count,
                       float* heights) const override;

private:
  TeNoiseSource(const TeNoiseSettings& settings, const TeNoiseKernel& kernel)
      : m_settings(settings), m_kernel(kernel) {}

  TeNoiseSettings m_settings;
  const TeNoiseKernel& m_kernel;
};
