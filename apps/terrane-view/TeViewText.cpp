#include "apps/terrane-view/TeViewText.h"

#include "apps/terrane-view/TeFlyCamera.h"
#include "apps/terrane-view/TeViewControls.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>

namespace {

/// Three digits together: 1 234 567.
std::string grouped(std::int64_t number) {
  std::string digits = std::to_string(number);
  for (int place = int(digits.size()) - 3; place > 0; place -= 3)
    digits.insert(std::size_t(place), " ");
  return digits;
}

std::string settings(const TeSeamlessNodes& nodes) {
  const std::string accuracy = nodes.pixelError() > 0 ? teFormat("error %.2f px wanted", nodes.pixelError())
                                                      : teFormat("precision %.2f", nodes.precision());
  return accuracy + (nodes.instancing() ? "  instanced" : "  classic") +
         (nodes.geomorph() ? "  geomorph" : "") + "  " + nodes.colouring();
}

} // namespace

std::vector<std::string> teViewLines(const TeSeamlessNodes& nodes, const TeViewPose& pose,
                                     double frameSeconds) {
  std::vector<std::string> lines;
  if (nodes.any()) {
    const TeSeamlessStatistics figures = nodes.statistics();
    lines.push_back("faces       " + grouped(figures.faces));
    lines.push_back("draw calls  " + grouped(figures.drawCalls));
    lines.push_back("patches     " + grouped(figures.traversed) + " traversed, " + grouped(figures.culled) +
                    " culled, " + grouped(figures.rendered) + " rendered");
    lines.push_back("uploaded    " + grouped(figures.bytesUploaded) + " bytes");
    const std::string bound = std::isfinite(figures.errorBound)
                                  ? teFormat("at most %.2f px", figures.errorBound)
                                  : std::string("not known");
    lines.push_back("error       " + bound + teFormat("  (precision %.2f)", figures.precision));
    lines.push_back("wanted      " + settings(nodes));
  }
  lines.push_back(teFormat("eye         %.1f  %.1f  %.1f", pose.eye.x, pose.eye.y, pose.eye.z));
  if (frameSeconds > 0)
    lines.push_back(teFormat("frame       %.1f ms", 1000 * frameSeconds));
  return lines;
}

std::vector<std::string> teViewHelp() {
  std::vector<std::string> lines = TeFlyCamera::helpLines();
  lines.emplace_back();
  for (std::string& line : TeViewControls::helpLines())
    lines.push_back(std::move(line));
  std::size_t width = 0;
  for (const std::string& line : lines)
    if (!line.empty())
      width = std::max(width, line.find("  "));
  for (std::string& line : lines)
    if (!line.empty())
      line.insert(line.find("  "), width - line.find("  "), ' ');
  return lines;
}
