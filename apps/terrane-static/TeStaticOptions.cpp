#include "apps/terrane-static/TeStaticOptions.h"

#include "generators/TeLattice.h"

#include <cmath>
#include <cstdio>

namespace {

/// "X,Y", both finite.
bool readPoint(const std::string& text, glm::dvec2& point) {
  int used = 0;
  return std::sscanf(text.c_str(), "%lf,%lf%n", &point.x, &point.y, &used) == 2 &&
         std::size_t(used) == text.size() && std::isfinite(point.x) && std::isfinite(point.y);
}

std::string checkPoint(std::string& text) {
  glm::dvec2 point;
  return readPoint(text, point) ? std::string() : "must be X,Y in metres, not '" + text + "'";
}

std::string checkOdd(std::string& text) {
  return (text.back() - '0') % 2 != 0 ? std::string() : "must be odd, not '" + text + "'";
}

} // namespace

void TeStaticOptions::addTo(TeCommandLine& commandLine) {
  addTerrain(commandLine);
  addElevationData(commandLine);
  addView(commandLine);
}

void TeStaticOptions::addTerrain(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  const std::string group = "Terrain";
  commandLine.addInteger("--block", block, 1, kMaxBlock, "Patches a side (default: 3)")->group(group);
  commandLine
      .addInteger("--samples", samples, TeLattice::kMinSamples, kMaxSamples,
                  "Samples a side of a source map, odd; a patch has half (default: 65)")
      ->check(CLI::Validator(checkOdd, ""))
      ->option_text("W")
      ->group(group);
  commandLine.addNumber("--spacing", spacing, 1e-6, 1e6, "Metres between samples (default: 1)")
      ->option_text("S")
      ->group(group);
  cli.add_option_function<std::string>(
         "--center", [this](const std::string& text) { readPoint(text, center); },
         "A point of the middle patch, metres (default: 0,0)")
      ->check(CLI::Validator(checkPoint, ""))
      ->option_text("X,Y")
      ->group(group);
  cli.add_option("--generator", generator, "Generator and parameters: name:parameter=value,...")
      ->check(TeCommandLine::notEmpty())
      ->option_text("SPEC")
      ->group(group);
  cli.add_option("--filter", filters, "Filter over the generator; may be given more than once")
      ->check(TeCommandLine::notEmpty())
      ->option_text("SPEC")
      ->allow_extra_args(false)
      ->group(group);
  cli.add_option_function<std::string>(
         "--blend",
         [this](const std::string& text) {
           blending = text == "linear" ? TeBlendProfile::Linear : TeBlendProfile::Smooth;
         },
         "Weights of the maps that make a patch: smooth, or linear as in the document (default: smooth)")
      ->check(CLI::IsMember({"linear", "smooth"}))
      ->option_text("PROFILE")
      ->group(group);
  cli.add_flag("--list-generators", listGenerators, "Print generators and filters with their parameters")
      ->group(group);
}

void TeStaticOptions::addElevationData(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  const std::string group = "Elevation data";
  CLI::Option* file = cli.add_option("--dem", dem, "Elevation file in place of a generator")
                          ->check(TeCommandLine::notEmpty())
                          ->option_text("FILE")
                          ->excludes("--generator")
                          ->group(group);
  cli.add_option("--vertical-unit", verticalUnit, "Of its heights: m, ft, dm, 0.1, ... (default: the file's)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("UNIT")
      ->needs(file)
      ->group(group);
  commandLine.addNumber("--posts", posts, 1e-6, 1e6, "Metres between its posts (default: as the file says)")
      ->needs(file)
      ->group(group);
  cli.add_option_function<std::string>(
         "--fill", [this](const std::string& what) { fillVoids = what == "voids"; },
         "voids: fill them from their surroundings (default: none)")
      ->check(CLI::IsMember({"none", "voids"}))
      ->option_text("WHAT")
      ->needs(file)
      ->group(group);
  cli.add_option("--outside", outside,
                 "Beyond the file: hole, clamp, a height, or a generator (default: hole)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("WHAT")
      ->needs(file)
      ->group(group);
  cli.add_flag("--native", native, "The file's own posts, around its highest (default: all of the file)")
      ->needs(file)
      ->group(group);
}

void TeStaticOptions::addView(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  const std::string group = "View";
  commandLine.addNumber("--vertical-scale", verticalScale, 1e-6, 1e6, "Stretches heights (default: 1)")
      ->group(group);
  cli.add_flag("--wireframe", wireframe, "Draw lines")->group(group);
  cli.add_flag("--parts", parts, "Patches, seams and corners in different colours")->group(group);
  cli.add_flag("--top", top, "Seen from straight above, north up")->group(group);
  cli.add_option("--water", water, "A sheet of water at this height, metres")
      ->check(TeCommandLine::within(-1e6, 1e6))
      ->option_text("LEVEL")
      ->group(group);
  cli.add_option("--drape", drape, "PNG picture laid over the block, north up")
      ->check(TeCommandLine::notEmpty())
      ->option_text("IMAGE")
      ->group(group);
  cli.add_option("--export", exportFile, "Write the scene as an Inventor file of Coin's own nodes")
      ->check(TeCommandLine::notEmpty())
      ->option_text("OUT.iv")
      ->group(group);
}

TeStatus TeStaticOptions::check() const {
  if (native && spacing != 0)
    return TeError{"--native and --spacing exclude each other"};
  return {};
}
