#pragma once

#include "apps/terrane-accuracy/TeHeightWorld.h"
#include "apps/terrane-accuracy/TeSpread.h"

#include <vector>

/// What is asked of the surface.
enum class TeHeightQuery {
  Near,      ///< heights at points of a walk
  Scattered, ///< heights at points anywhere
  Together,  ///< the same in one call, at level 0 only
  Ray        ///< first hits of rays from 150 m above the ground, 14 to 45 degrees down
};
constexpr TeHeightQuery kTeHeightQueries[] = {TeHeightQuery::Near, TeHeightQuery::Scattered,
                                              TeHeightQuery::Together, TeHeightQuery::Ray};
const char* teNameOf(TeHeightQuery query);

/// One kind of query at one level.
struct TeHeightFigures {
  TeHeightQuery query = TeHeightQuery::Near;
  int level = 0;
  std::int64_t queries = 0;
  TeSpread ns;      ///< CPU time of a query
  double ratio = 0; ///< to heights near each other at level 0: median of runs in turn
  /// Against level 0, metres: of heights; of rays, how far the base surface lies above or below the hit.
  double rms = 0;
  double worst = 0;
  double bound = 0;        ///< mean of what the queries' patches say at most
  std::int64_t over = 0;   ///< answers that lie farther than was said
  std::int64_t missed = 0; ///< rays that hit at one level and not at the other
};

/// All queries at all levels of a world; the same places at all.
std::vector<TeHeightFigures> teMeasureHeights(const TeHeightWorld& world, int queries, int runs);
