#pragma once

#include "patchdb/TeMapJob.h"
#include "patchdb/TeMapProvider.h"

/// Makes source maps for one job, one after the other.
class TeOwnMaps final : public TeMapProvider {
public:
  explicit TeOwnMaps(TePatchDatabase& database) : m_database(&database) {}
  TeProgress provide(TeMapKey key, TeAllowance& allowance, TeSourceMapPtr& map, TeError& error) override;

private:
  TePatchDatabase* m_database;
  std::optional<TeMapJob> m_job;
};
