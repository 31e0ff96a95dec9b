#include "apps/terrane-accuracy/TeHeightSweep.h"

#include "generators/base/TeAllowance.h"
#include "generators/base/TeRandom.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kClearance = 150;

/// Where it is asked.
struct Places {
  std::vector<glm::dvec2> walk, anywhere;
  std::vector<glm::dvec3> origins, directions;
  double length = 0; ///< of rays, in their directions

  Places(const TeHeightWorld& world, int count) {
    TeRandom random(4, 4, {});
    const double side = world.side();
    glm::dvec2 walker(0.5 * side, 0.5 * side);
    for (int i = 0; i < count; ++i) {
      walker += 0.02 * TeHeightWorld::kCells * world.database().lattice().spacing() *
                glm::dvec2(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
      walker = {std::clamp(walker.x, 0.0, side), std::clamp(walker.y, 0.0, side)};
      walk.push_back({world.at(walker.x), world.at(walker.y)});
      anywhere.push_back({world.at(random.uniform(0, side)), world.at(random.uniform(0, side))});
      const glm::dvec2 from(world.at(random.uniform(0.25, 0.75) * side),
                            world.at(random.uniform(0.25, 0.75) * side));
      origins.push_back({from, world.database().heightAt(from).value_or(0) + kClearance});
      const double angle = random.uniform(0, 6.283185307179586);
      directions.push_back({std::cos(angle), std::sin(angle), random.uniform(-1.0, -0.25)});
    }
    length = 0.25 * side; // stays over the land
  }
};

/// `rounding`: of what was computed besides heights.
void addError(double error, double bound, double rounding, TeHeightFigures& figures) {
  figures.rms += error * error;
  figures.worst = std::max(figures.worst, error);
  figures.bound += bound;
  figures.over += error > bound + rounding ? 1 : 0;
}

void measurePoints(const TePatchDatabase& database, const std::vector<glm::dvec2>& points,
                   TeHeightFigures& figures) {
  for (const glm::dvec2& point : points) {
    const std::optional<TeSurfacePoint> coarse = database.surfaceAt(point, figures.level);
    const std::optional<double> fine = database.heightAt(point);
    if (coarse && fine)
      addError(std::fabs(coarse->height - *fine), coarse->deviation, 0, figures);
    else
      ++figures.missed;
  }
}

void measureTogether(const TePatchDatabase& database, const std::vector<glm::dvec2>& points,
                     TeHeightFigures& figures) {
  std::vector<double> heights(points.size());
  database.heightsAt(points.data(), points.size(), heights.data());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const std::optional<double> height = database.heightAt(points[i]))
      addError(std::fabs(heights[i] - *height), 0, 0, figures);
    else
      ++figures.missed;
}

/// A hit lies on the level's surface, so that the base surface is to be as near there as is said.
void measureRays(const TePatchDatabase& database, const Places& places, TeHeightFigures& figures) {
  for (std::size_t i = 0; i < places.origins.size(); ++i) {
    const auto hit =
        database.intersect(places.origins[i], places.directions[i], places.length, figures.level);
    const auto base = database.intersect(places.origins[i], places.directions[i], places.length);
    figures.missed += hit.has_value() != base.has_value() ? 1 : 0;
    if (!hit)
      continue;
    const std::optional<double> fine = database.heightAt({hit->position.x, hit->position.y});
    const TePatchData* patch = database.find(hit->key);
    if (fine && patch)
      addError(std::fabs(hit->position.z - *fine), double(patch->deviation()), 1e-6, figures);
  }
}

/// Seconds of one query. (Calls into another library: none can be left out.)
double secondsOf(const TePatchDatabase& database, const Places& places, const TeHeightFigures& figures) {
  const std::vector<glm::dvec2>& points =
      figures.query == TeHeightQuery::Near ? places.walk : places.anywhere;
  std::vector<double> heights(figures.query == TeHeightQuery::Together ? points.size() : 0);
  const double start = teThreadCpuSeconds();
  if (figures.query == TeHeightQuery::Together) {
    database.heightsAt(points.data(), points.size(), heights.data());
  } else if (figures.query == TeHeightQuery::Ray) {
    for (std::size_t i = 0; i < places.origins.size(); ++i)
      database.intersect(places.origins[i], places.directions[i], places.length, figures.level);
  } else if (figures.level == 0) {
    for (const glm::dvec2& point : points)
      database.heightAt(point);
  } else {
    for (const glm::dvec2& point : points)
      database.surfaceAt(point, figures.level);
  }
  return (teThreadCpuSeconds() - start) / double(points.size());
}

} // namespace

const char* teNameOf(TeHeightQuery query) {
  const char* const names[] = {"height near", "height scattered", "heights in one call", "ray"};
  return names[int(query)];
}

std::vector<TeHeightFigures> teMeasureHeights(const TeHeightWorld& world, int queries, int runs) {
  const Places places(world, queries);
  const TePatchDatabase& database = world.database();
  std::vector<TeHeightFigures> all;
  for (const TeHeightQuery query : kTeHeightQueries)
    for (int level = 0; level < (query == TeHeightQuery::Together ? 1 : world.levels()); ++level) {
      TeHeightFigures figures;
      figures.query = query;
      figures.level = level;
      figures.queries = queries;
      if (query == TeHeightQuery::Ray)
        measureRays(database, places, figures);
      else if (query == TeHeightQuery::Together)
        measureTogether(database, places.anywhere, figures);
      else
        measurePoints(database, query == TeHeightQuery::Near ? places.walk : places.anywhere, figures);
      figures.rms = std::sqrt(figures.rms / queries);
      figures.bound /= queries;
      all.push_back(figures);
    }
  std::vector<std::vector<double>> ns(all.size());
  for (int run = 0; run < runs; ++run)
    for (std::size_t i = 0; i < all.size(); ++i)
      ns[i].push_back(1e9 * secondsOf(database, places, all[i]));
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].ns = TeSpread::of(ns[i]);
    std::vector<double> ratios;
    for (int run = 0; run < runs; ++run)
      ratios.push_back(ns[i][std::size_t(run)] / std::max(ns[0][std::size_t(run)], 1e-9));
    all[i].ratio = TeSpread::of(ratios).median;
  }
  return all;
}
