#pragma once

#include "apps/terrane-accuracy/TeLodSweep.h"
#include "apps/terrane-accuracy/TePlot.h"
#include "apps/terrane-accuracy/TeTable.h"

#include <optional>
#include <string>

/// What `terrane-accuracy lod` has measured: one row for each method, layout and accuracy. Times are in ms,
/// columns *_low_ms and *_high_ms their quartiles; frame_ratio is to
/// raw_frame_ms (TeRawMesh), the median of the frames' ratios.
class TeLodTable {
public:
  TeLodTable();

  /// `drawn`: empty if nothing was drawn.
  void add(const TeLodCandidate& candidate, const TeLodAccuracy& accuracy, int frames,
           const TeLodFigures& figures, const std::optional<TeFrameFigures>& drawn);

  const TeTable& table() const { return m_table; }
  /// True errors over a column of cost, a curve for each method and layout; lines for those without errors.
  TePlot plot(const std::string& title, const std::string& column, const std::string& label) const;

private:
  TeTable m_table;
};
