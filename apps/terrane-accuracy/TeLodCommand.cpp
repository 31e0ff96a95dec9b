#include "apps/terrane-accuracy/TeLodCommand.h"

#include "apps/common/TeExit.h"
#include "apps/common/TeProgressLine.h"
#include "apps/terrane-accuracy/TeLayoutText.h"
#include "nodes/lod/TeLodMethods.h"

#include <cstdio>
#include <cstdlib>

namespace {

std::string listOf(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// "VALUE" or "METHOD=VALUE".
bool readDial(const std::string& text, TeLodSettings::Dial& dial) {
  const std::size_t equals = text.find('=');
  dial.method = equals == std::string::npos ? std::string() : text.substr(0, equals);
  const std::string number = equals == std::string::npos ? text : text.substr(equals + 1);
  char* end = nullptr;
  dial.value = std::strtod(number.c_str(), &end);
  return !number.empty() && *end == 0 && dial.value > 0 && dial.value <= 1e12 && equals != 0;
}

std::string checkDial(std::string& text) {
  TeLodSettings::Dial dial;
  return readDial(text, dial) ? std::string() : "must be VALUE or METHOD=VALUE, not '" + text + "'";
}

std::string checkMethod(std::string& text) { return TeLodCandidate::checkName(text); }

} // namespace

TeLodCommand::TeLodCommand(TeCommandLine& commandLine)
    : m_commandLine(commandLine),
      m_cli(commandLine.cli().add_subcommand("lod", "Measures level-of-detail methods on a flight: cost and "
                                                    "true errors")) {
  m_cli->fallthrough();
  m_terrain.addTo(*m_cli);
  const std::string group = "Measuring";
  m_cli->add_flag("--flyover", m_flyover, "Fly the circle of half a degree a frame (default)")->group(group);
  m_cli
      ->add_option("--methods", m_settings.methods,
                   listOf(TeLodMethods::names()) + ", or with -geomorph (default: all)")
      ->delimiter(',')
      ->check(CLI::Validator(checkMethod, ""))
      ->option_text("LIST")
      ->group(group);
  m_cli->add_flag("--geomorph", m_geomorph, "Of methods that morph measure that form, too")->group(group);
  m_cli
      ->add_option("--layout", m_settings.layouts,
                   "Of Seamless Patches: lowest resolution of a patch and number of resolutions (default: "
                   "16/3)")
      ->delimiter(',')
      ->check(CLI::Validator(teCheckLayout, ""))
      ->option_text("LIST")
      ->group(group);
  m_cli
      ->add_option("--px", m_pixels,
                   "Wanted screen errors, pixels (default: 0.25,0.5,1,2,4,8,16,32, unless there are dials)")
      ->delimiter(',')
      ->check(TeCommandLine::within(1e-3, 1e4))
      ->option_text("LIST")
      ->group(group);
  m_cli
      ->add_option("--dial", m_dials,
                   "The methods' own dials: numbers for all that have one, or METHOD=NUMBER")
      ->delimiter(',')
      ->check(CLI::Validator(checkDial, ""))
      ->option_text("LIST")
      ->group(group);
  m_cli
      ->add_option("--stride", m_settings.frames.stride,
                   "Measure every N-th frame of the flight (default: 1)")
      ->transform(TeCommandLine::wholeWithin(1, 720))
      ->option_text("N")
      ->group(group);
  m_cli->add_flag("--no-draw", m_noDraw, "Measure what the CPU does only")->group(group);
  m_cli->add_option("--out", m_folder, "Folder for what is written (default: accuracy)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("DIR")
      ->group(group);
}

TeLodSettings TeLodCommand::settings() const {
  TeLodSettings settings = m_settings;
  if (!m_pixels.empty() || !m_dials.empty())
    settings.pixels = m_pixels;
  for (const std::string& text : m_dials) {
    settings.dials.emplace_back();
    readDial(text, settings.dials.back());
  }
  const TeCommonOptions& common = m_commandLine.common();
  if (common.frames > 0)
    settings.frames.count = common.frames;
  settings.width = common.width;
  settings.height = common.height;
  settings.geomorph = m_geomorph;
  return settings;
}

int TeLodCommand::run() {
  const std::string& application = m_commandLine.application();
  const TeCommonOptions& common = m_commandLine.common();
  TeAccuracyOutput output(m_commandLine, "lod", m_folder);
  TeResult<TeMeasuredTerrain> terrain = m_terrain.read();
  if (!terrain)
    return teExitWith(TeExitUsage, application, terrain.error().message);
  TeResult<TeLodRun> run = TeLodRun::create(std::move(*terrain), settings());
  if (!run)
    return teExitWith(TeExitUsage, application, run.error().message);
  if (const TeStatus ok = output.prepare(); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  std::unique_ptr<TeFlightStage> stage;
  if (!m_noDraw) {
    TeResult<std::unique_ptr<TeFlightStage>> made =
        TeFlightStage::create(*teContextKind(common.context), common.width, common.height);
    if (!made)
      return teExitWith(TeExitFailure, application, made.error().message);
    stage = std::move(*made);
  }

  {
    TeProgressLine progress("Measuring", common.quiet);
    if (const TeStatus ok = run->measure(stage.get(), [&](double done) { progress.update(done); }); !ok)
      return teExitWith(TeExitFailure, application, ok.error().message);
  }
  run->describe(output);
  if (!common.quiet)
    std::fputs(run->table().markdown().c_str(), stdout);
  if (const TeStatus ok = output.write(run->table()); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  return TeExitSuccess;
}
