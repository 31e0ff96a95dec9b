#pragma once

#include "patchdb/TePatchKey.h"

/// Order of jobs of one kind: lower rank first, then lower distance, then the key and part, so that ties
/// never depend on the order of insertion.
struct TeUrgency {
  int rank = 0;        ///< 0 = most urgent
  double distance = 0; ///< metres or seconds; not NaN
  TePatchKey key;
  int part = 0; ///< tells jobs for one patch apart

  friend bool operator<(const TeUrgency& a, const TeUrgency& b) {
    if (a.rank != b.rank)
      return a.rank < b.rank;
    if (a.distance != b.distance)
      return a.distance < b.distance;
    if (a.key != b.key)
      return a.key < b.key;
    return a.part < b.part;
  }
};
