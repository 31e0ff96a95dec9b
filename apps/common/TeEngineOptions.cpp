#include "apps/common/TeEngineOptions.h"

#include <algorithm>
#include <cmath>

void TeEngineOptions::addTo(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  terrain.addTo(commandLine);
  commandLine.addPoint("--center", center, "Where to begin, metres (default: 0,0)")->group("Terrain");

  const std::string engine = "Engine";
  commandLine
      .addInteger("--radius", radius, 1, TeEngine::kMaxRadius,
                  "Patches around the middle one that are shown: (2N+1)x(2N+1) in all (default: 1)")
      ->group(engine);
  CLI::Option* time =
      commandLine
          .addNumber("--budget", budget, 0.01, 1000, "Milliseconds a tick for making terrain (default: 4)")
          ->option_text("MS")
          ->group(engine);
  commandLine
      .addInteger("--units", units, 1, kMaxUnits,
                  "Units of work a tick in place of time, so that runs repeat (default with --dt: " +
                      std::to_string(kDefaultUnits) + ")")
      ->excludes(time)
      ->group(engine);
  commandLine
      .addNumber("--fps", fps, 1, 1000,
                 "Wanted frames a second, to which the budget and the pixel error adapt; not with --dt "
                 "(default: none)")
      ->excludes("--units")
      ->group(engine);
  commandLine
      .addNumber("--pixel-error", pixelError, kLeastPixelError, TeEngine::kMostPixelError,
                 "Pixels that what is drawn may deviate from all samples; with --fps the least "
                 "(default: 0, or with --fps 0.5)")
      ->option_text("PX")
      ->group(engine);
  commandLine
      .addInteger("--workers", workers, 0, TeEngine::kMaxWorkers,
                  "Threads that fill source maps (default: 0)")
      ->group(engine);
  CLI::Option* recording = cli.add_option("--record", record, "Write keys and states of all ticks")
                               ->check(TeCommandLine::notEmpty())
                               ->option_text("FILE")
                               ->group(engine);
  cli.add_option("--replay", replay, "Repeat a recording and compare every state with it")
      ->check(TeCommandLine::notEmpty())
      ->option_text("FILE")
      ->excludes(recording)
      ->group(engine);

  const std::string view = "View";
  cli.add_option("--haze", haze, "on, off, or auto: where the radius is more than 1 (default: auto)")
      ->check(CLI::IsMember({"on", "off", "auto"}))
      ->option_text("HOW")
      ->group(view);
  cli.add_option_function<std::string>(
         "--hud", [this](const std::string& text) { hud = text == "on"; },
         "Figures over the picture: on or off (default: on)")
      ->check(CLI::IsMember({"on", "off"}))
      ->option_text("HOW")
      ->group(view);
  cli.add_option_function<std::string>(
         "--view", [this](const std::string& text) { thirdPerson = text == "third"; },
         "first person or third (default: first)")
      ->check(CLI::IsMember({"first", "third"}))
      ->option_text("PERSON")
      ->group(view);
  cli.add_option("--screenshots", screenshots, "Folder for F12's pictures (default: the present one)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("FOLDER")
      ->group(view);
}

TeStatus TeEngineOptions::check(const TeCommonOptions& common) const {
  if (units != 0 && common.dt == 0)
    return TeError{"--units needs --dt: without it time decides"};
  return terrain.check();
}

SbBool TeEngineOptions::apply(TeEngine& engine, const TeCommonOptions& common) const {
  const double rate = common.dt > 0 ? 0 : fps;
  const double finest = pixelError > 0 ? pixelError : TeQuality::kFinest;
  return engine.setBudget(budget / 1000) && engine.setUnitBudget(unitBudget(common)) &&
         engine.setFrameRate(rate) && engine.setPixelError(pixelError) &&
         engine.setQualityRange(finest, std::max(finest, TeQuality::kCoarsest)) &&
         engine.setQualityGoal(rate);
}

int TeEngineOptions::unitBudget(const TeCommonOptions& common) const {
  if (units != 0 || common.dt == 0)
    return units;
  return std::max(1, int(std::lround(kDefaultUnits * budget / (TeEngine::kDefaultBudget * 1000))));
}
