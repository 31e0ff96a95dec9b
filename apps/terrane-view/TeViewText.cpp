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

std::string boundText(double pixels, const char* none) {
  return std::isfinite(pixels) ? teFormat("at most %.2f px", pixels) : std::string(none);
}

std::string settings(const TeLodNodes& nodes) {
  const std::string accuracy = nodes.pixelError() > 0 ? teFormat("error %.2f px wanted", nodes.pixelError())
                                                      : teFormat("precision %.2f", nodes.precision());
  return accuracy + (nodes.instancing() ? "  instanced" : "  classic") +
         (nodes.geomorph() ? "  geomorph" : "") + "  " + nodes.colouring();
}

} // namespace

std::vector<std::string> teViewLines(const TeLodNodes& nodes, const TeViewPose& pose, double frameSeconds) {
  std::vector<std::string> lines;
  if (nodes.anySeamless()) {
    const TeSeamlessStatistics figures = nodes.seamlessStatistics();
    lines.push_back("faces       " + grouped(figures.faces));
    lines.push_back("draw calls  " + grouped(figures.drawCalls));
    lines.push_back("patches     " + grouped(figures.traversed) + " traversed, " + grouped(figures.culled) +
                    " culled, " + grouped(figures.rendered) + " rendered");
    lines.push_back("uploaded    " + grouped(figures.bytesUploaded) + " bytes");
    lines.push_back("error       " + boundText(figures.errorBound, "not known") +
                    teFormat("  (precision %.2f)", figures.precision));
    lines.push_back("wanted      " + settings(nodes));
  }
  for (const TeNodePtr<SoTeLodTerrain>& node : nodes.lodTerrains()) {
    const std::vector<std::string> more = teLodLines(*node, node->statistics());
    lines.insert(lines.end(), more.begin(), more.end());
  }
  lines.push_back(teFormat("eye         %.1f  %.1f  %.1f", pose.eye.x, pose.eye.y, pose.eye.z));
  if (frameSeconds > 0)
    lines.push_back(teFormat("frame       %.1f ms", 1000 * frameSeconds));
  return lines;
}

std::vector<std::string> teLodLines(const SoTeLodTerrain& node, const TeLodStatistics& figures) {
  std::string error = boundText(figures.errorBound, "no bound");
  if (std::isfinite(figures.dial))
    error += teFormat("  (dial %.4g)", figures.dial);
  const double dial = double(node.dial.getValue());
  std::string wanted =
      dial > 0 ? teFormat("dial %.4g", dial) : teFormat("error %.2f px", double(node.pixelError.getValue()));
  if (node.geomorph.getValue())
    wanted += "  geomorph";
  return {"method      " + std::string(node.method.getValue().getString()),
          "triangles   " + grouped(figures.triangles),
          "draw calls  " + grouped(figures.drawCalls),
          "uploaded    " + grouped(figures.bytesUploaded) + " bytes",
          "error       " + error,
          "wanted      " + wanted};
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
