#pragma once

#include "generators/TeHeightSource.h"
#include "generators/base/TeRandom.h"
#include "generators/circles/TeCircle.h"
#include "generators/circles/TeCirclesParameters.h"

/// The circles algorithm (document 002, §3.2.2): each iteration picks a random centre and radius and raises
/// or lowers all inside by a rounded hill.
///
/// Radii are smallest + (largest - smallest)·u², u uniform, so that small ones are frequent; heights
/// height·(R / largest)·v, v uniform in [-1, 1), so that all are about equally steep. A centre is uniform
/// over the map's cells and a margin of its own radius around them, so that every sample is as likely to be
/// covered as any other. Maps of any size. A sample is the sum of its hills in the order of the circles, in
/// single precision. Evaluable at scattered samples.
///
/// Cost: the circles' areas. Memory: the map. A point: one hill a circle after drawing all circles;
/// many points at most a map.
class TeCircles final : public TeHeightSource {
public:
  /// Error: a parameter out of its range; the least radius greater than the greatest.
  static TeResult<std::shared_ptr<const TeCircles>> create(TeCirclesParameters parameters);

  std::string name() const override { return "circles"; }
  std::uint64_t fingerprint() const override { return m_fingerprint; }
  bool pointEvaluable() const override { return true; }
  std::unique_ptr<TeHeightJob> start(const TeMapRequest& request) const override;
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override;

  const TeCirclesParameters& parameters() const { return m_parameters; }
  /// The random stream that a map's circles are drawn from.
  TeRandom random(const TeMapRequest& request) const;
  /// Circle 0 .. circles-1 of a map.
  TeCircle circle(const TeMapRequest& request, const TeRandom& random, int index) const;

private:
  explicit TeCircles(const TeCirclesParameters& parameters);

  TeCirclesParameters m_parameters;
  std::uint64_t m_fingerprint;
};
