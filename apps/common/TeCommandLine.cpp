#include "apps/common/TeCommandLine.h"

#include "apps/common/TeContextChoice.h"
#include "apps/common/TeExit.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace {

std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

/// A decimal number and nothing else. (CLI11 takes 010 for 8, and -1 and 2^64 for numbers without sign.)
template <class Whole> bool readWhole(std::string_view text, Whole& value) {
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  return read.ec == std::errc() && read.ptr == end;
}

/// Writes the number so that CLI11 reads it the same.
std::string checkSeed(std::string& text) {
  std::uint64_t seed = 0;
  if (!readWhole(text, seed))
    return "must be a whole number from 0 to 18446744073709551615, not '" + text + "'";
  text = std::to_string(seed);
  return {};
}

bool readSize(std::string_view text, int& width, int& height) {
  const std::size_t cross = text.find('x');
  const auto inRange = [](int side) { return side >= 1 && side <= TeCommonOptions::kMaxSide; };
  return cross != std::string_view::npos && readWhole(text.substr(0, cross), width) &&
         readWhole(text.substr(cross + 1), height) && inRange(width) && inRange(height);
}

std::string checkSize(std::string& text) {
  int width = 0, height = 0;
  if (readSize(text, width, height))
    return {};
  return "must be WIDTHxHEIGHT, each from 1 to " + std::to_string(TeCommonOptions::kMaxSide) + ", not '" +
         text + "'";
}

bool readPoint(const std::string& text, glm::dvec2& point) {
  int used = 0;
  return std::sscanf(text.c_str(), "%lf,%lf%n", &point.x, &point.y, &used) == 2 &&
         std::size_t(used) == text.size() && std::isfinite(point.x) && std::isfinite(point.y);
}

std::string checkPoint(std::string& text) {
  glm::dvec2 point;
  return readPoint(text, point) ? std::string() : "must be X,Y in metres, not '" + text + "'";
}

} // namespace

TeCommandLine::TeCommandLine(const std::string& application, const std::string& description, bool draws)
    : m_cli(description, application), m_application(application) {
  m_common.context = teContextChoice(0, nullptr);
  const std::string common = "Common options";
  m_cli.get_formatter()->column_width(34);
  m_cli.set_help_flag("-h,--help", "Print this and exit")->group(common);
  m_cli.set_version_flag("--version", application + " " TERRANE_VERSION, "Print the version and exit")
      ->group(common);
  if (draws)
    addDrawing(common);
  m_cli.add_option("--seed", m_common.seed, "The world's seed (default: 0)")
      ->transform(CLI::Validator(checkSeed, ""))
      ->option_text("N")
      ->group(common);
  m_cli.add_option("--report", m_common.report, "Write what was done and measured")
      ->check(notEmpty())
      ->option_text("OUT.json")
      ->group(common);
  m_cli.add_flag("--quiet", m_common.quiet, "Print errors only")->group(common);
}

void TeCommandLine::addDrawing(const std::string& group) {
  m_cli
      .add_option("--context", m_common.context,
                  "window, egl or osmesa (default: window if there is a display)")
      ->check(CLI::IsMember({"window", "egl", "osmesa"}))
      ->option_text("NAME")
      ->group(group);
  m_cli.add_option("--offscreen", m_common.offscreen, "Write the last frame as a PNG picture")
      ->check(notEmpty())
      ->option_text("OUT.png")
      ->group(group);
  m_cli.add_option("--size", m_size, "Pixels (default: 1024x768)")
      ->check(CLI::Validator(checkSize, ""))
      ->option_text("WxH")
      ->group(group);
  addInteger("--frames", m_common.frames, 1, 1'000'000'000, "Frames to draw, then exit")->group(group);
  addNumber("--dt", m_common.dt, 0, 86400, "Seconds a frame, for runs that repeat exactly")->group(group);
}

CLI::Option* TeCommandLine::addNumber(const std::string& name, double& value, double minimum, double maximum,
                                      const std::string& help) {
  return m_cli.add_option(name, value, help)->check(within(minimum, maximum))->option_text("X");
}

CLI::Option* TeCommandLine::addInteger(const std::string& name, int& value, int minimum, int maximum,
                                       const std::string& help) {
  return m_cli.add_option(name, value, help)->transform(wholeWithin(minimum, maximum))->option_text("N");
}

CLI::Option* TeCommandLine::addPoint(const std::string& name, glm::dvec2& value, const std::string& help) {
  return m_cli
      .add_option_function<std::string>(
          name, [&value](const std::string& text) { readPoint(text, value); }, help)
      ->check(CLI::Validator(checkPoint, ""))
      ->option_text("X,Y");
}

std::optional<int> TeCommandLine::parse(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    m_commandText += std::string(i > 1 ? " " : "") + argv[i];
  try {
    m_cli.parse(argc, argv);
  } catch (const CLI::Success& request) { // help, version
    return m_cli.exit(request);
  } catch (const CLI::ParseError& error) {
    return teExitWith(TeExitUsage, m_application, std::string(error.what()) + " (--help lists the options)");
  }
  readSize(m_size, m_common.width, m_common.height);
  return {};
}

CLI::Validator TeCommandLine::within(double minimum, double maximum) {
  const auto check = [minimum, maximum](std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= minimum && value <= maximum)
      return {};
    return "must be a number from " + numberText(minimum) + " to " + numberText(maximum) + ", not '" + text +
           "'";
  };
  return CLI::Validator(check, "");
}

CLI::Validator TeCommandLine::wholeWithin(int minimum, int maximum) {
  const auto check = [minimum, maximum](std::string& text) -> std::string {
    int value = 0;
    if (!readWhole(text, value) || value < minimum || value > maximum)
      return "must be a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum) +
             ", not '" + text + "'";
    text = std::to_string(value);
    return {};
  };
  return CLI::Validator(check, "");
}

CLI::Validator TeCommandLine::notEmpty() {
  return CLI::Validator(
      [](std::string& text) { return text.empty() ? std::string("must not be empty") : std::string(); }, "");
}
