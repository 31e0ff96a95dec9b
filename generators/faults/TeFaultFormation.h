#pragma once

#include "generators/TeHeightSource.h"
#include "generators/base/TeRandom.h"
#include "generators/faults/TeFaultParameters.h"
#include "generators/faults/TeFaultPlane.h"

#include <vector>

/// Fault formation (document 002, §3.2.3): each iteration draws a line through two random points of the map;
/// all on one side of it rises by the same amount, which falls with the iteration.
///
/// Maps of any size. A height is the sum of integers, rounded once to float: the bits of the plain loop (a
/// side test per sample and fault), from spans instead: a fault's line crosses a row once. Evaluable at
/// scattered samples.
///
/// Cost, W×H samples and N faults: N·H crossings and W·H additions (smooth profile: three crossings, of
/// difference arrays of third order). Memory: the map and 50 bytes a fault. A point: N side tests after
/// drawing N faults; many points at most a map.
class TeFaultFormation final : public TeHeightSource {
public:
  /// Error: a parameter out of its range.
  static TeResult<std::shared_ptr<const TeFaultFormation>> create(TeFaultParameters parameters);

  std::string name() const override { return "faults"; }
  std::uint64_t fingerprint() const override { return m_fingerprint; }
  bool pointEvaluable() const override { return true; }
  std::unique_ptr<TeHeightJob> start(const TeMapRequest& request) const override;
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override;

  const TeFaultParameters& parameters() const { return m_parameters; }
  int faults() const { return int(m_amplitudes.size()); }
  bool isSmooth() const { return m_smooth; }

  /// The random stream that a map's faults are drawn from.
  TeRandom random(const TeMapRequest& request) const;
  /// Line of fault 0 .. faults()-1 in a map. Its points are uniform over the cells of the map's samples; if
  /// both have the same y (also if they coincide), b is moved 1/256 of a sample north.
  TeFaultLine line(const TeMapRequest& request, const TeRandom& random, int fault) const;
  /// The amount by which a fault raises, in units of unit(); the sum over all faults is at most 2^24 + N/2.
  std::int64_t amplitude(int fault) const { return m_amplitudes[std::size_t(fault)]; }
  /// Metres, a power of two.
  double unit() const { return m_unit; }
  /// Samples across a fault's ramp in a map of this spacing.
  double rampWidth(int fault, double spacing) const;
  TeFaultPlane plane(const TeMapRequest& request, const TeRandom& random, int fault) const;
  /// Metres, from the sums of the heights of all faults in samples, bases included; each rounded once.
  void heights(const std::int64_t* sums, std::size_t count, float* metres) const;

private:
  explicit TeFaultFormation(TeFaultParameters parameters);
  bool mapIsCheaper(const TeMapRequest& request, std::size_t count) const;

  TeFaultParameters m_parameters;
  bool m_smooth;
  std::uint64_t m_fingerprint;
  std::vector<std::int32_t> m_amplitudes;
  double m_unit = 1;
  float m_sumUnit = 1;
  std::int64_t m_level = 0;
};
