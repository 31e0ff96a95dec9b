#pragma once

#include "patchdb/TeFourMapBlend.h"
#include "patchdb/TeMapJob.h"

#include <array>

/// Makes one base patch in slices: finds or makes its four source maps, blends them, and stores the result in
/// the patch's record. Any slicing and any order of jobs gives the same bits. The database must outlive the
/// job; the record may come and go meanwhile.
class TePatchJob {
public:
  TePatchJob(TePatchDatabase& database, const TePatchKey& key);

  /// Does work until the allowance is spent, at least one unit.
  TeProgress step(TeAllowance& allowance);
  TeProgress finish();
  TeProgress progress() const { return m_progress; }
  const TePatchKey& key() const { return m_key; }
  /// Only after Failed.
  const TeError& error() const { return m_error; }

  /// Key of the source map of a corner: 0 = south-west, 1 = south-east, 2 = north-west, 3 = north-east.
  static TeMapKey mapKey(const TePatchKey& patch, int corner) {
    return {patch.x + corner % 2, patch.y + corner / 2};
  }

private:
  TeProgress makeMaps(TeAllowance& allowance);
  TeProgress makeHeights(TeAllowance& allowance);
  TeProgress fail(const TeError& error);

  TePatchDatabase* m_database;
  TePatchKey m_key;
  TeProgress m_progress = TeProgress::Working;
  TeError m_error;
  std::unique_ptr<TeMapJob> m_mapJob;
  std::array<TeSourceMapPtr, 4> m_maps;
  TeHeightMap m_heights;
  std::unique_ptr<TeFourMapBlend> m_blend;
};
