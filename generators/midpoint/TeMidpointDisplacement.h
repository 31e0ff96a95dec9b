#pragma once

#include "generators/TeHeightSource.h"
#include "generators/base/TeRandom.h"
#include "generators/midpoint/TeMidpointParameters.h"

/// Midpoint displacement on a square (document 002, §3.2.1; document 000, §2.2): the four corners are random;
/// then, level by level, the centre E of each square with corners A B C D is (A+B+C+D)/4 + rand(d), and the
/// middle of each edge the mean of all its known neighbours plus rand(d): (A+B+E)/3 + rand(d) on the map's
/// rim, the mean of two corners and two centres inside, so that an edge has one height, whichever of its two
/// squares is looked at. Each square is replaced by its four quarters, d by fall·d.
///
/// Maps of 2^n + 1 samples a side, n ≥ 0, square; any other size is an error. The random number of a sample
/// depends on the sample alone, so the order within a level does not matter. Sums are in double precision,
/// rounded to float when stored.
///
/// Cost: 4 additions and 1 (uniform) or 3 (gaussian) random numbers a sample. Memory: the map. A height
/// depends on coarser ones all over the map: not evaluable at scattered samples.
class TeMidpointDisplacement final : public TeHeightSource {
public:
  /// Error: a parameter out of its range.
  static TeResult<std::shared_ptr<const TeMidpointDisplacement>> create(TeMidpointParameters parameters);

  std::string name() const override { return "midpoint"; }
  std::uint64_t fingerprint() const override { return m_fingerprint; }
  TeStatus accepts(int columns, int rows) const override;
  std::unique_ptr<TeHeightJob> start(const TeMapRequest& request) const override;

  const TeMidpointParameters& parameters() const { return m_parameters; }
  bool isGaussian() const { return m_gaussian; }

  TeRandom random(const TeMapRequest& request) const;
  /// rand(1) of sample number row·columns + column: uniform in [-1, 1), or normal with deviation 1 (the sum
  /// of twelve uniform numbers less 6: never beyond ±6).
  double displacement(const TeRandom& random, std::uint64_t sample) const;

private:
  explicit TeMidpointDisplacement(TeMidpointParameters parameters);

  TeMidpointParameters m_parameters;
  bool m_gaussian;
  std::uint64_t m_fingerprint;
};
