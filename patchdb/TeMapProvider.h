#pragma once

#include "generators/TeHeightSource.h"
#include "patchdb/TeSourceMap.h"

/// Where a TePatchJob gets its source maps from. A job asks for a map with request(), gets it from provide(),
/// and gives it back with release(), each request once, be it early.
class TeMapProvider {
public:
  virtual ~TeMapProvider() = default;
  /// Somebody needs the map from now on.
  virtual void request(TeMapKey) {}
  virtual void release(TeMapKey) {}
  /// Works on a map that was requested until the allowance is spent. Done: `map` is set; costs nothing where
  /// the map is there. Failed: `error` is set.
  virtual TeProgress provide(TeMapKey key, TeAllowance& allowance, TeSourceMapPtr& map, TeError& error) = 0;
  /// A map that was requested is needed before all others: it is not to be waited for.
  virtual void hurry(TeMapKey) {}
  /// True if the map is being made elsewhere, so that provide() would do nothing.
  virtual bool blocked(TeMapKey) const { return false; }
};
