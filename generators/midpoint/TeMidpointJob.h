#pragma once

#include "generators/TeHeightSource.h"
#include "generators/midpoint/TeMidpointDisplacement.h"

/// Makes a map by midpoint displacement, level by level: first all centres, then all edge middles. A unit is
/// a bounded number of samples.
class TeMidpointJob final : public TeHeightJob {
public:
  TeMidpointJob(std::shared_ptr<const TeMidpointDisplacement> source, const TeMapRequest& request);

protected:
  TeProgress unit() override;

private:
  enum class Pass { Centres, Edges };

  void setCorners();
  /// Column of the first sample that the present pass sets in a row.
  int firstColumn(int row) const;
  void beginPass(Pass pass);
  void setCentre(int x, int y);
  void setEdge(int x, int y);
  void store(int x, int y, double mean);

  std::shared_ptr<const TeMidpointDisplacement> m_source;
  TeMapRequest m_request;
  TeRandom m_random;
  double m_displacement; ///< d of the present level
  int m_half = 0;        ///< half of the side of its squares; 0: no level is left
  Pass m_pass = Pass::Centres;
  int m_x = 0; ///< next sample
  int m_y = 0;
};
