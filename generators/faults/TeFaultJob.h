#pragma once

#include "generators/TeHeightSource.h"
#include "generators/faults/TeFaultPainter.h"

/// Makes a map by fault formation: draws the faults, then paints the map. A unit is a bounded number of
/// faults drawn, or one unit of the painter.
class TeFaultJob final : public TeHeightJob {
public:
  TeFaultJob(std::shared_ptr<const TeFaultFormation> source, const TeMapRequest& request);

protected:
  TeProgress unit() override;

private:
  std::shared_ptr<const TeFaultFormation> m_source;
  TeMapRequest m_request;
  TeRandom m_random;
  TeFaultPainter m_painter;
  int m_drawn = 0;
};
