#pragma once

#include "patchdb/TeHeightBuilder.h"
#include "patchdb/TeMapJob.h"

/// Makes one base patch in slices: finds or makes its source maps, blends them, and stores the result in
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

  /// Finds or makes the maps; Done when all are there.
  TeProgress makeMaps(TeAllowance& allowance);
  const TePatchMaps& maps() const { return m_maps; }

private:
  TeProgress makeHeights(TeAllowance& allowance);
  TeProgress fail(const TeError& error);

  TePatchDatabase* m_database;
  TePatchKey m_key;
  TeProgress m_progress = TeProgress::Working;
  TeError m_error;
  std::optional<TeNeededMaps> m_needed;
  std::unique_ptr<TeMapJob> m_mapJob;
  TePatchMaps m_maps;
  std::unique_ptr<TeHeightBuilder> m_builder;
};
