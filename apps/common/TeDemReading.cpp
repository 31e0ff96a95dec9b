#include "apps/common/TeDemReading.h"

void TeDemReading::addTo(CLI::App& cli, CLI::Option* dem, const std::string& group) {
  cli.add_option("--vertical-unit", verticalUnit, "Of its heights: m, ft, dm, 0.1, ... (default: the file's)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("UNIT")
      ->needs(dem)
      ->group(group);
  cli.add_option("--posts", posts, "Metres between its posts (default: as the file says)")
      ->check(TeCommandLine::within(1e-6, 1e6))
      ->option_text("X")
      ->needs(dem)
      ->group(group);
  cli.add_option_function<std::string>(
         "--fill", [this](const std::string& what) { fillVoids = what == "voids"; },
         "voids: fill them from their surroundings (default: none)")
      ->check(CLI::IsMember({"none", "voids"}))
      ->option_text("WHAT")
      ->needs(dem)
      ->group(group);
}

TeResult<TeElevationOptions> TeDemReading::options() const {
  const TeResult<double> unit = teVerticalUnit(verticalUnit);
  if (!unit)
    return TeError{"--vertical-unit: " + unit.error().message};
  TeElevationOptions options;
  options.verticalUnit = *unit;
  options.posts = posts;
  options.fillDistance = fillVoids ? kFillDistance : 0;
  return options;
}
