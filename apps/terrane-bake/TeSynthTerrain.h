#pragma once

#include "apps/terrane-bake/TeSynthBase.h"
#include "generators/noise/TeNoiseKernel.h"

#include <cstdint>
#include <vector>

/// A terrain of any size over the large forms of a base: between its heights Catmull-Rom's splines (1974),
/// and on them gradient noise of wavelengths from the base's spacing down to two samples. The noise is as
/// high as the land around is rough (at most a quarter of the largest difference among the 3 × 3 nearest
/// heights of the base), so that the sea, lakes and plains stay flat. A height is a function of base, seed,
/// size and place; the same bits on every machine. Rows may be asked for in any order; neighbouring ones
/// share work.
class TeSynthTerrain {
public:
  /// side: 2^n + 1 samples.
  TeSynthTerrain(TeSynthBase base, int side, std::uint64_t seed);

  double spacing() const { return TeSynthBase::kExtent / (m_side - 1); } ///< metres
  int octaves() const { return m_octaves; }
  /// A row from the north, in steps of TeSynthBase::kHeightUnit.
  void row(int row, std::uint16_t* heights);

private:
  /// Between which heights of the base a sample lies: the second of four, and their weights.
  struct Place {
    int post = 0;
    double fraction = 0;
    double weights[4];
  };
  Place place(int index) const;
  int inside(int post) const;
  void measureRoughness();

  TeSynthBase m_base;
  int m_side;
  int m_octaves;
  TeNoisePlan m_plan;
  std::vector<float> m_roughness; ///< of the base, as its heights
  std::vector<Place> m_places;    ///< by column
  std::vector<double> m_line;     ///< the base's columns at a row, one more at each end but one
  std::vector<double> m_roughLine;
  std::vector<float> m_noise;
};
