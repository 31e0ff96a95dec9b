#pragma once

#include "generators/TeHeightMap.h"

#include <vector>

/// The radially averaged power spectrum of square height maps, in octaves of wavelength.
///
/// The mean is taken off, the map weighted by a Hann window in both directions and transformed (a plain
/// radix-2 FFT in double precision). Band b holds the squared magnitudes at the frequencies of 2^b up to
/// 2^(b+1) periods across the map.
class TeRadialSpectrum {
public:
  /// `side`: a power of two, at least 4; the first so many rows and columns of maps are looked at.
  explicit TeRadialSpectrum(int side);

  int bands() const { return int(m_power.size()); }
  /// Adds a map of at least side × side samples, none missing.
  void add(const TeHeightMap& map);
  /// Each band's share of the power of all maps that were added; 0 if they are flat.
  std::vector<double> shares() const;

  /// Root mean square over the bands of the difference in dB; bands that hold less than 10^-12 of either are
  /// left out.
  static double difference(const std::vector<double>& shares, const std::vector<double>& reference);

private:
  int m_side;
  std::vector<double> m_power;
};
