#include "apps/terrane-flight/TeFlightOptions.h"

#include "engine/paths/TeNamedPaths.h"

void TeFlightOptions::addTo(TeCommandLine& commandLine) {
  const std::string group = "Flight";
  std::string names;
  for (const std::string& name : tePathNames())
    names += name + ", ";
  commandLine.cli()
      .add_option("--path", path, "Fly by itself: " + names + "or a file of waypoints")
      ->check(TeCommandLine::notEmpty())
      ->option_text("PATH")
      ->group(group);
  commandLine.cli()
      .add_option("--speed", speed, "Metres a second, at the start or all along the path (default: 40)")
      ->check(TeCommandLine::within(0, kMaxSpeed))
      ->option_text("X")
      ->group(group);
  commandLine.cli()
      .add_option(
          "--altitude", altitude,
          "Metres above the ground, at the start or along a built-in path (default: suits the radius)")
      ->check(TeCommandLine::within(0, 1e6))
      ->option_text("X")
      ->group(group);
}

TeStatus TeFlightOptions::check() const {
  if (!path.empty() && speed == 0.0)
    return TeError{"--speed: must be more than 0 on a path"};
  return {};
}
