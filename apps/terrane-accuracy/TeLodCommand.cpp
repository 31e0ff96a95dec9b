#include "apps/terrane-accuracy/TeLodCommand.h"

#include "apps/common/TeProgressLine.h"
#include "apps/terrane-accuracy/TeLayoutText.h"
#include "nodes/lod/TeLodMethods.h"

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
    : TeAccuracyCommand(commandLine, "lod",
                        "Measures level-of-detail methods on a flight: cost and true errors") {
  m_choice.addTo(cli());
  addFlag("--flyover", m_flyover, "Fly the circle of half a degree a frame (default)");
  addList("--methods", m_settings.methods, CLI::Validator(checkMethod, ""),
          listOf(TeLodMethods::names()) + ", or with -geomorph (default: all)");
  addFlag("--geomorph", m_settings.geomorph, "Of methods that morph measure that form, too");
  addList("--layout", m_settings.layouts, CLI::Validator(teCheckLayout, ""),
          "Of Seamless Patches: lowest resolution of a patch and number of resolutions (default: 16/3)");
  addList("--px", m_pixels, TeCommandLine::within(1e-3, 1e4),
          "Wanted screen errors, pixels (default: 0.25,0.5,1,2,4,8,16,32, unless there are dials)");
  addList("--dial", m_dials, CLI::Validator(checkDial, ""),
          "The methods' own dials: numbers for all that have one, or METHOD=NUMBER");
  addInteger("--stride", m_settings.frames.stride, 1, 720,
             "Measure every N-th frame of the flight (default: 1)");
  addNoDraw("Measure what the CPU does only");
  addOutput();
}

TeLodSettings TeLodCommand::settings() const {
  TeLodSettings settings = m_settings;
  if (!m_pixels.empty() || !m_dials.empty())
    settings.pixels = m_pixels;
  for (const std::string& text : m_dials) {
    settings.dials.emplace_back();
    readDial(text, settings.dials.back());
  }
  settings.frames.count = framesOr(settings.frames.count);
  settings.width = common().width;
  settings.height = common().height;
  return settings;
}

TeStatus TeLodCommand::read() {
  TeResult<TeMeasuredTerrain> terrain = m_choice.read();
  if (!terrain)
    return terrain.error();
  return keep(TeLodRun::create(std::move(*terrain), settings()), m_run);
}

TeResult<TeTable> TeLodCommand::measure(TeAccuracyOutput& output) {
  const TeResult<std::unique_ptr<TeFlightStage>> stage = makeStage();
  if (!stage)
    return stage.error();
  {
    TeProgressLine progress("Measuring", common().quiet);
    if (const TeStatus ok = m_run->measure(stage->get(), [&](double done) { progress.update(done); }); !ok)
      return ok.error();
  }
  m_run->describe(output);
  return m_run->table();
}
