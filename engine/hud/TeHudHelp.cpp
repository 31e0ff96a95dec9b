#include "engine/hud/TeHudHelp.h"

#include "engine/camera/TeCameraRig.h"
#include "engine/objects/TeObject.h"

#include <algorithm>

namespace {

const std::vector<std::string> kEngineHelp = {"F1, /  this help", "H  figures", "P  pause",
                                              "W, F3, X  wireframe"};

/// Where a line's meaning begins; 0 if it has no keys.
std::size_t meaningOf(const std::string& line) {
  const std::size_t gap = line.find("  ");
  const std::size_t meaning = gap == std::string::npos ? gap : line.find_first_not_of(' ', gap);
  return meaning == std::string::npos ? 0 : meaning;
}

std::string keysOf(const std::string& line) { return line.substr(0, line.find("  ")); }

} // namespace

std::vector<std::string> teHudHelp(const TeObject& object, const TeCameraRig& rig,
                                   const std::vector<std::string>& program) {
  std::vector<std::string> lines;
  for (const std::vector<std::string>& part : {object.helpLines(), rig.helpLines(), kEngineHelp, program}) {
    if (!lines.empty() && !part.empty())
      lines.emplace_back();
    lines.insert(lines.end(), part.begin(), part.end());
  }
  std::size_t width = 0;
  for (const std::string& line : lines)
    if (meaningOf(line) > 0)
      width = std::max(width, keysOf(line).size());
  for (std::string& line : lines)
    if (const std::size_t meaning = meaningOf(line); meaning > 0) {
      std::string keys = keysOf(line);
      keys.resize(width + 2, ' ');
      line = keys + line.substr(meaning);
    }
  return lines;
}
