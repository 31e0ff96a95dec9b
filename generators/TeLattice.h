#pragma once

#include "generators/base/TeResult.h"

#include <cstdint>

/// Key of a source map: map (x, y) is centred on the south-west corner of patch (x, y) of level 0.
struct TeMapKey {
  std::int64_t x = 0;
  std::int64_t y = 0;

  friend bool operator==(const TeMapKey& a, const TeMapKey& b) { return a.x == b.x && a.y == b.y; }
  friend bool operator!=(const TeMapKey& a, const TeMapKey& b) { return !(a == b); }
};

/// The base lattice on which a world is sampled.
///
/// W samples a side of a source map (odd), spacing s metres; n = (W-1)/2 cells a side of a patch, P = n·s
/// metres. *Global samples* are numbered from the south-west corner of patch (0, 0): sample (gx, gy) lies at
/// (gx·s - P/2, gy·s - P/2), so that patch (0, 0) is centred on the world's origin. Patch (i, j) has the
/// samples i·n .. i·n + n, source map (i, j) the samples (i-1)·n .. (i+1)·n. Keys up to ±2^47 keep every
/// sample number inside 64 bits.
class TeLattice {
public:
  static constexpr int kMinSamples = 5;
  static constexpr int kMaxSamples = 16385; ///< a map of 1 GiB
  static constexpr std::int64_t kMaxKey = std::int64_t(1) << 47;

  TeLattice() = default;
  /// Error for even or out-of-range W and for a spacing that is not finite and positive.
  static TeResult<TeLattice> create(int samples, double spacing);

  int samples() const { return m_samples; }                ///< W
  int cells() const { return (m_samples - 1) / 2; }        ///< n
  double spacing() const { return m_spacing; }             ///< s, metres
  double patchSide() const { return cells() * m_spacing; } ///< P, metres

  /// Global number of a map's first column (key.x) or row (key.y).
  std::int64_t mapFirstSample(std::int64_t key) const { return (key - 1) * cells(); }
  /// World coordinate of a global sample, metres.
  double position(std::int64_t sample) const;
  /// The sample at or west/south of a coordinate (finite, in the range of keys); fraction in [0, 1). Exact
  /// inverse of position() for samples up to ±2^52; farther out samples share positions: one close by.
  std::int64_t sampleBelow(double position, double& fraction) const;

  friend bool operator==(const TeLattice& a, const TeLattice& b) {
    return a.m_samples == b.m_samples && a.m_spacing == b.m_spacing;
  }

private:
  int m_samples = 65;
  double m_spacing = 1.0;
};
