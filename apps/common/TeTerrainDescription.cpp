#include "apps/common/TeTerrainDescription.h"

#include "generators/base/TePartFile.h"

#include <cmath>
#include <fstream>
#include <sys/stat.h>

TeStatus TeTerrainDescription::write(const std::string& path) const {
  nlohmann::ordered_json json;
  json["samples"] = samples;
  json["sample_bytes"] = sampleBytes;
  json["kind"] = colour ? "colour" : "height";
  json["spacing_m"] = spacing;
  if (!colour) {
    json["height_unit_m"] = heightUnit;
    json["height_offset_m"] = heightOffset;
  }
  if (levels > 0)
    json["levels"] = levels;
  json["source"] = source;
  return TePartFile::writeWhole(path,
                                json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

TeStatus TeTerrainDescription::readIfThere(const std::string& path) {
  struct stat status;
  if (::stat(path.c_str(), &status) != 0)
    return {};
  constexpr off_t kMostBytes = 1 << 16;
  constexpr double kLargest = 1e8; // metres
  if (!S_ISREG(status.st_mode) || status.st_size > kMostBytes)
    return TeError{path + ": not the description of a terrain"};
  std::ifstream stream(path);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  const auto number = [&](const char* name, double& value) {
    if (!json.contains(name))
      return true;
    if (json[name].is_number())
      value = json[name].get<double>();
    return json[name].is_number() && std::isfinite(value) && std::abs(value) <= kLargest;
  };
  if (!json.is_object() || !number("spacing_m", spacing) || !number("height_unit_m", heightUnit) ||
      !number("height_offset_m", heightOffset) || spacing < 0 || heightUnit < 0)
    return TeError{path + ": not the description of a terrain: spacing_m, height_unit_m or height_offset_m "
                          "is no number that can be"};
  return {};
}
