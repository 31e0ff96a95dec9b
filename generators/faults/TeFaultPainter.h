#pragma once

#include "generators/TeHeightMap.h"
#include "generators/faults/TeFaultFormation.h"
#include "generators/faults/TeFaultSweep.h"

/// Makes the map of a set of faults in bounded steps: sweeps strips of columns by bands of rows.
class TeFaultPainter {
public:
  /// The source tells how sums become heights; it must outlive the painter.
  explicit TeFaultPainter(const TeFaultFormation& source) : m_source(&source), m_sweep(source.isSmooth()) {}

  /// Adds a fault; only before the first paint().
  void add(const TeFaultPlane& fault) { m_sweep.add(fault); }
  /// One unit of work, about 0.1 ms whatever the map's size; true when the whole map is written. The same
  /// map each time.
  bool paint(TeHeightMap& map);

private:
  void beginStrip(const TeHeightMap& map, int first);
  void beginBand(const TeHeightMap& map, int first);
  /// Adds some faults to the present band of rows, or writes a row of it; returns the work done.
  std::int64_t sweep(TeHeightMap& map);

  const TeFaultFormation* m_source;
  TeFaultSweep m_sweep;
  int m_stripFirst = -1; ///< first column of the strip; -1: not begun
  int m_stripWidth = 0;
  int m_bandFirst = 0; ///< first row of the band
  int m_bandRows = 0;  ///< rows of the present band
  int m_maxBandRows = 0;
  int m_bandRow = 0;       ///< rows of it that are written
  std::size_t m_added = 0; ///< faults that are in it
  std::vector<std::int64_t> m_sums;
};
