#include "apps/terrane-bake/TeTerrainDescription.h"

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
  if (!S_ISREG(status.st_mode) || status.st_size > kMostBytes)
    return TeError{path + ": not the description of a terrain"};
  std::ifstream stream(path);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  const auto number = [&](const char* name, double& value) {
    if (!json.is_object() || !json.contains(name) || !json[name].is_number())
      return false;
    value = json[name].get<double>();
    return std::isfinite(value);
  };
  if (!number("spacing_m", spacing) || !number("height_unit_m", heightUnit) ||
      !number("height_offset_m", heightOffset) || spacing <= 0 || heightUnit <= 0)
    return TeError{path + ": needs the positive numbers spacing_m and height_unit_m, and height_offset_m"};
  return {};
}
