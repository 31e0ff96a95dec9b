#pragma once

#include "patchdb/TePatchDatabase.h"

/// Starts the making of a source map, with the source that the database remembers for it. Error: no source,
/// or one that makes no maps of this size; as of TeMapJob.
TeResult<std::unique_ptr<TeHeightJob>> teStartMap(TePatchDatabase& database, TeMapKey key);
/// Stores what a started job has made, once it is done or has failed. Error: it failed, or lied about the
/// size; as of TeMapJob.
TeResult<TeSourceMapPtr> teStoreMap(TePatchDatabase& database, TeMapKey key, TeHeightJob& ended);

/// Finds one source map in a database or makes it, in slices. The map is looked for again at every slice:
/// of two jobs that make it at the same time the first to finish stores it (TeMapMaker has one make it).
/// Errors name the map. The database must outlive the job.
class TeMapJob {
public:
  TeMapJob(TePatchDatabase& database, TeMapKey key) : m_database(&database), m_key(key) {}

  TeMapKey key() const { return m_key; }
  /// Does work until the allowance is spent, at least one unit unless the map is there already.
  TeProgress step(TeAllowance& allowance);
  /// Only after Done.
  const TeSourceMapPtr& map() const { return m_map; }
  /// Only after Failed.
  const TeError& error() const { return m_error; }

private:
  TeProgress fail(const TeError& error);

  TePatchDatabase* m_database;
  TeMapKey m_key;
  std::unique_ptr<TeHeightJob> m_job;
  TeSourceMapPtr m_map;
  TeError m_error;
};
