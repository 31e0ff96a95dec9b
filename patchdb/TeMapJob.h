#pragma once

#include "patchdb/TePatchDatabase.h"

/// Finds one source map in a database or makes it, in slices. The map is asked for again at every start, so
/// that two jobs for neighbouring patches may make it at the same time: the first to finish stores it.
/// The database must outlive the job.
class TeMapJob {
public:
  TeMapJob(TePatchDatabase& database, TeMapKey key) : m_database(&database), m_key(key) {}

  /// Does work until the allowance is spent, at least one unit unless the map is there already.
  TeProgress step(TeAllowance& allowance);
  /// Only after Done.
  const TeSourceMapPtr& map() const { return m_map; }
  /// Only after Failed.
  const TeError& error() const { return m_error; }

private:
  TeStatus start();
  TeProgress fail(const TeError& error);

  TePatchDatabase* m_database;
  TeMapKey m_key;
  std::unique_ptr<TeHeightJob> m_job;
  TeSourceMapPtr m_map;
  TeError m_error;
};
