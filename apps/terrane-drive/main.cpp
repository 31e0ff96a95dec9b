// terrane-drive: a car on endless terrain.

#include "apps/common/TeEngineRun.h"
#include "apps/terrane-drive/TeDriveApp.h"

namespace {

/// Hills: the mean slope is 0.26, and one place in a hundred is steeper than 0.6, which is about what the car
/// climbs. Samples 2 m apart are as close as the wheels, so the ground moves the suspension, and a patch
/// (64 m) is large enough for a view over a small block.
constexpr const char* kHills = "noise:wavelength=350,amplitude=60,octaves=8,gain=0.5";
constexpr double kSpacing = 2;
constexpr int kRadius = 3;

/// Grass, with rock where the car does not climb, and snow on the highest tops. (Heights: mean 0, standard
/// deviation 11 m.)
TeSurfaceColours hillColours() {
  TeSurfaceColours colours;
  colours.rockLine = 18;
  colours.snowLine = 30;
  colours.blend = 10;
  colours.rockSlope = 0.55f;
  colours.slopeBlend = 0.4f;
  return colours;
}

/// What is different from other applications of the engine unless it is asked for.
void setDefaults(TeEngineOptions& options, TeCommandLine& commandLine) {
  options.terrain.generator = kHills;
  options.radius = kRadius;
  options.thirdPerson = true;
  const auto describe = [&](const char* option, const char* text) {
    commandLine.cli().get_option(option)->description(text);
  };
  describe("--generator", "Generator and parameters: name:parameter=value,... (default: rounded hills)");
  describe("--spacing", "Metres between samples (default: 2)");
  describe("--radius", "Patches around the middle one that are shown: (2N+1)x(2N+1) in all (default: 3)");
  describe("--view", "first person or third (default: third)");
}

} // namespace

extern "C" int teMain(int argc, char** argv) {
  TeCommandLine commandLine("terrane-drive", "Drives a car over endless terrain.");
  TeEngineOptions options;
  options.addTo(commandLine);
  setDefaults(options, commandLine);
  TeDriveApp app;
  app.addTo(commandLine);
  if (const std::optional<int> status = commandLine.parse(argc, argv))
    return *status;
  if (options.terrain.spacing == 0 && options.terrain.dem.empty())
    options.terrain.spacing = kSpacing;
  if (options.terrain.generator == kHills && options.terrain.dem.empty())
    app.setColours(hillColours());
  return teRunEngine(commandLine, options, app);
}
