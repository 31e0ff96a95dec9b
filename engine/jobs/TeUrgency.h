#pragma once

#include "patchdb/TePatchKey.h"

/// Order of jobs of one kind: lower rank first, then lower distance, then the key, so that ties never depend
/// on the order of insertion.
struct TeUrgency {
  int rank = 0;        ///< 0 = most urgent
  double distance = 0; ///< metres or seconds; not NaN
  TePatchKey key;

  friend bool operator<(const TeUrgency& a, const TeUrgency& b) {
    if (a.rank != b.rank)
      return a.rank < b.rank;
    if (a.distance != b.distance)
      return a.distance < b.distance;
    return a.key < b.key;
  }
};
