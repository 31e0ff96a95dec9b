#pragma once

#include "generators/TeHeightSource.h"
#include "generators/faults/TeFaultFormation.h"
#include "generators/faults/TeFaultSweep.h"

/// Makes a map by fault formation: draws the faults, then sweeps strips of columns by bands of rows. A unit
/// is a bounded number of faults drawn, of knots moved and of samples written, whatever the map's size.
class TeFaultJob final : public TeHeightJob {
public:
  TeFaultJob(std::shared_ptr<const TeFaultFormation> source, const TeMapRequest& request);

protected:
  TeProgress unit() override;

private:
  void drawFaults();
  /// Adds some knots to the present band of rows, or writes a row of it; returns the work done.
  std::int64_t sweep();
  void beginStrip(int first);
  void beginBand(int first);

  std::shared_ptr<const TeFaultFormation> m_source;
  TeMapRequest m_request;
  TeRandom m_random;
  TeFaultSweep m_sweep;
  int m_drawn = 0;
  int m_stripFirst = 0;
  int m_stripWidth = 0;
  int m_bandFirst = 0; ///< first row of the band
  int m_bandRows = 0;  ///< rows of the present band
  int m_maxBandRows = 0;
  int m_bandRow = 0;      ///< rows of it that are written
  std::size_t m_knot = 0; ///< knots that are in it
  std::vector<std::int64_t> m_sums;
};
