#include "apps/common/TeTerrainOptions.h"

#include "generators/TeLattice.h"

namespace {

std::string checkOdd(std::string& text) {
  return (text.back() - '0') % 2 != 0 ? std::string() : "must be odd, not '" + text + "'";
}

} // namespace

void TeTerrainOptions::addTo(TeCommandLine& commandLine) {
  addTerrain(commandLine);
  addElevationData(commandLine);
}

void TeTerrainOptions::addTerrain(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  const std::string group = "Terrain";
  commandLine
      .addInteger("--samples", samples, TeLattice::kMinSamples, kMaxSamples,
                  "Samples a side of a source map, odd; a patch has half (default: 65)")
      ->check(CLI::Validator(checkOdd, ""))
      ->option_text("W")
      ->group(group);
  commandLine.addNumber("--spacing", spacing, 1e-6, 1e6, "Metres between samples (default: 1)")
      ->option_text("S")
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

void TeTerrainOptions::addElevationData(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  const std::string group = "Elevation data";
  CLI::Option* file = cli.add_option("--dem", dem, "Elevation file in place of a generator")
                          ->check(TeCommandLine::notEmpty())
                          ->option_text("FILE")
                          ->excludes("--generator")
                          ->group(group);
  reading.addTo(cli, file, group);
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

TeStatus TeTerrainOptions::check() const {
  if (native && spacing != 0)
    return TeError{"--native and --spacing exclude each other"};
  return {};
}
