#pragma once

#include "generators/TeHeightSource.h"
#include "patchdb/TeSourceMap.h"

/// Where a TePatchJob gets its source maps from.
class TeMapProvider {
public:
  virtual ~TeMapProvider() = default;
  /// Works on the map until the allowance is spent. Done: `map` is set. Failed: `error` is set.
  virtual TeProgress provide(TeMapKey key, TeAllowance& allowance, TeSourceMapPtr& map, TeError& error) = 0;
  /// True if the map is being made elsewhere, so that provide() would do nothing.
  virtual bool blocked(TeMapKey) const { return false; }
  /// Nobody waits for the map any more.
  virtual void release(TeMapKey) {}
};
