#include "engine/hud/TeHudLines.h"

#include "engine/TeStatistics.h"
#include "engine/objects/TeObject.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>

namespace {

/// To one decimal, and never "-0.0".
double tenths(double value) { return std::round(10 * value) / 10 + 0.0; }

template <class... Values> std::string format(const char* pattern, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

} // namespace

std::vector<std::string> teHudLines(const TeObject& object, const TeStatistics& statistics) {
  const glm::dvec3& position = object.position();
  const glm::dvec3& velocity = object.velocity();
  std::vector<std::string> lines;
  lines.push_back(object.name());
  lines.push_back(
      format("position  %.1f  %.1f  %.1f m", tenths(position.x), tenths(position.y), tenths(position.z)));
  lines.push_back(format("velocity  %.1f  %.1f  %.1f m/s  (%.1f)", tenths(velocity.x), tenths(velocity.y),
                         tenths(velocity.z), glm::length(velocity)));
  lines.push_back(std::isnan(statistics.heightAboveGround)
                      ? std::string("height    above unknown ground")
                      : format("height    %.1f m above ground", tenths(statistics.heightAboveGround)));
  for (std::string& line : object.hudLines())
    lines.push_back(std::move(line));
  lines.push_back(format("frame     %.1f ms   budget  %.1f ms", 1000 * statistics.frameSeconds,
                         1000 * statistics.budgetSeconds));
  lines.push_back(format("patches   %lld of %lld drawn   error  %.2f px", (long long)statistics.patches.drawn,
                         (long long)statistics.patches.block, statistics.errorBoundPixels));
  return lines;
}
