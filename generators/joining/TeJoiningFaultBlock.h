#pragma once

#include "generators/base/TeAllowance.h"
#include "generators/faults/TeFaultFormation.h"
#include "generators/faults/TeFaultPainter.h"
#include "generators/joining/TeJoiningFault.h"

#include <memory>
#include <vector>

/// What a block of joining maps is made of.
struct TeJoiningFaultParameters {
  TeFaultParameters faults;    ///< the profile must be `step`
  int columns = 3;             ///< maps from west to east, at least 1
  int rows = 3;                ///< maps from south to north, at least 1
  int samples = 65;            ///< of the visible part of a map, a side; 3 .. 16385
  int overlap = 1;             ///< samples by which a map goes on beyond its visible part; 1 .. samples - 1
  std::uint64_t worldSeed = 0; ///< maps are numbered from (0, 0) in the south-west
};

/// A block of maps made by fault formation so that they fit: the earlier method of document 002, §4.2, kept
/// for comparison.
///
/// Maps are made from the south-west, row by row. In each iteration a map that has neighbours in the south
/// and west takes over their faults where they cross the common side, at the same coordinate; otherwise it
/// picks at random among the types that fit (TeFaultType). So heights agree on the common side. A map goes on
/// beyond its visible part by `overlap` samples, and in these and as many inside, the neighbours' samples,
/// which were there before, replace its own: so normals agree too.
///
/// A map depends on all maps to its south and west: unlike the other generators it is not pure by key, and
/// not for endless worlds. The bits are the same for any slicing. Neighbours share one
/// row or column of their visible parts: visible sample (c, r) of map (i, j) is sample (i·(samples-1) + c,
/// j·(samples-1) + r) of the block.
class TeJoiningFaultBlock {
public:
  /// Error: a parameter out of its range, or more than TeHeightMap::kMaxSamples samples or 2^26 faults in
  /// all.
  static TeResult<TeJoiningFaultBlock> create(const TeJoiningFaultParameters& parameters);

  /// Does units of work (each at most about 0.25 ms) until the allowance is spent, at least one; true when
  /// all maps are complete.
  bool step(TeAllowance& allowance);
  void finish();
  bool done() const { return m_next == int(m_maps.size()); }

  const TeJoiningFaultParameters& parameters() const { return m_parameters; }
  /// Map (i, j) with its overlap, samples + 2·overlap a side; visible sample (c, r) is its sample
  /// (c + overlap, r + overlap). Empty until it has been begun, right once done().
  const TeHeightMap& map(int i, int j) const { return m_maps[index(i, j)]; }
  /// Fault k of map (i, j); only once done().
  const TeJoiningFault& fault(int i, int j, int k) const { return m_faults[index(i, j)][std::size_t(k)]; }
  /// Amplitudes and the way from sums to heights, as in a single map.
  const TeFaultFormation& formation() const { return *m_formation; }

private:
  TeJoiningFaultBlock(const TeJoiningFaultParameters& parameters,
                      std::shared_ptr<const TeFaultFormation> formation);

  std::size_t index(int i, int j) const { return std::size_t(j) * std::size_t(m_parameters.columns) + i; }
  int physicalSamples() const { return m_parameters.samples + 2 * m_parameters.overlap; }
  void unit();
  void chooseFaults(int i, int j);
  TeJoiningFault chooseFault(int i, int j, int k) const;
  std::int32_t randomCoordinate(std::uint64_t random) const;
  void takeOverlaps(int i, int j);

  TeJoiningFaultParameters m_parameters;
  std::shared_ptr<const TeFaultFormation> m_formation;
  std::vector<TeHeightMap> m_maps;
  std::vector<std::vector<TeJoiningFault>> m_faults;
  int m_next = 0; ///< the map in progress
  std::unique_ptr<TeFaultPainter> m_painter;
};
