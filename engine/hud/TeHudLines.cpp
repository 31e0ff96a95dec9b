#include "engine/hud/TeHudLines.h"

#include "engine/TeStatistics.h"
#include "engine/objects/TeObject.h"
#include "generators/base/TeText.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr std::size_t kLongest = 159; ///< a line, bytes

/// To one decimal, and never "-0.0".
double tenths(double value) { return std::round(10 * value) / 10 + 0.0; }

/// Three digits together: 1,234,567.
std::string grouped(std::int64_t number) {
  std::string digits = std::to_string(number);
  for (int place = int(digits.size()) - 3; place > 0; place -= 3)
    digits.insert(std::size_t(place), ",");
  return digits;
}

/// What the accuracy costs.
std::string accuracyLine(const TeStatistics& statistics) {
  const std::string cost = statistics.drawing.seconds > 0
                               ? teFormat("   drawing  %.1f ms", 1000 * statistics.drawing.seconds)
                               : "";
  return teFormat("detail    %.2f px wanted   ", statistics.pixelError) +
         grouped(statistics.drawing.triangles) + " triangles" + cost;
}

} // namespace

std::vector<std::string> teHudLines(const TeObject& object, const TeStatistics& statistics) {
  const glm::dvec3& position = object.position();
  const glm::dvec3& velocity = object.velocity();
  std::vector<std::string> lines;
  lines.push_back(object.name());
  lines.push_back(
      teFormat("position  %.1f  %.1f  %.1f m", tenths(position.x), tenths(position.y), tenths(position.z)));
  lines.push_back(teFormat("velocity  %.1f  %.1f  %.1f m/s  (%.1f)", tenths(velocity.x), tenths(velocity.y),
                           tenths(velocity.z), glm::length(velocity)));
  lines.push_back(std::isnan(statistics.heightAboveGround)
                      ? std::string("height    above unknown ground")
                      : teFormat("height    %.1f m above ground", tenths(statistics.heightAboveGround)));
  for (std::string& line : object.hudLines())
    lines.push_back(std::move(line));
  const std::string goal =
      statistics.frameGoalSeconds > 0 ? teFormat(" of %.1f", 1000 * statistics.frameGoalSeconds) : "";
  lines.push_back(teFormat("frame     %.1f", 1000 * statistics.frameSeconds) + goal +
                  teFormat(" ms   budget  %.1f ms", 1000 * statistics.budgetSeconds));
  lines.push_back(teFormat("patches   %lld of %lld drawn   error  %.2f px",
                           (long long)statistics.patches.drawn, (long long)statistics.patches.block,
                           statistics.errorBoundPixels));
  if (statistics.pixelError > 0)
    lines.push_back(accuracyLine(statistics));
  for (std::string& line : lines)
    line.resize(std::min(line.size(), kLongest));
  return lines;
}
