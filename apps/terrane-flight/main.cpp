// terrane-flight: a flight over endless terrain, by the user or along a path, in a window or as a picture.

#include "apps/common/TeEngineRun.h"
#include "apps/terrane-flight/TeFlightApp.h"

extern "C" int teMain(int argc, char** argv) {
  TeCommandLine commandLine("terrane-flight", "Flies over endless terrain.");
  TeEngineOptions options;
  options.addTo(commandLine);
  TeFlightOptions flight;
  flight.addTo(commandLine);
  if (const std::optional<int> status = commandLine.parse(argc, argv))
    return *status;
  TeFlightApp app(flight, options);
  return teRunEngine(commandLine, options, app);
}
