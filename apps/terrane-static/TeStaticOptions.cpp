#include "apps/terrane-static/TeStaticOptions.h"

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

std::string checkSamples(std::string& text) {
  int samples = 0;
  if (CLI::detail::lexical_cast(text, samples) && samples % 2 == 1 && samples >= TeLattice::kMinSamples &&
      samples <= TeStaticOptions::kMaxSamples)
    return {};
  return "must be an odd number from " + std::to_string(TeLattice::kMinSamples) + " to " +
         std::to_string(TeStaticOptions::kMaxSamples) + ", not '" + text + "'";
}

} // namespace

void TeStaticOptions::addTo(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  const std::string terrain = "Terrain", data = "Elevation data", view = "View";
  const double huge = 1e15;

  commandLine.addInteger("--block", block, 1, kMaxBlock, "Patches a side (default: 3)")->group(terrain);
  cli.add_option("--samples", samples, "Samples a side of a source map, odd; a patch has half (default: 65)")
      ->check(CLI::Validator(checkSamples, ""))
      ->option_text("W")
      ->group(terrain);
  commandLine.addNumber("--spacing", spacing, 1e-6, 1e6, "Metres between samples (default: 1)")
      ->option_text("S")
      ->group(terrain);
  cli.add_option("--center", m_center, "A point of the middle patch, metres (default: 0,0)")
      ->check(CLI::Validator(checkPoint, ""))
      ->option_text("X,Y")
      ->group(terrain)
      ->each([this](const std::string& text) { readPoint(text, center.emplace()); });
  cli.add_option("--generator", generator, "Generator with its parameters, name:parameter=value,...")
      ->option_text("SPEC")
      ->group(terrain);
  cli.add_option("--filter", filters, "Filter over the generator; may be given more than once")
      ->option_text("SPEC")
      ->allow_extra_args(false)
      ->group(terrain);
  cli.add_flag("--list-generators", listGenerators, "Print generators and filters with their parameters")
      ->group(terrain);

  cli.add_option("--dem", dem, "Elevation file instead of a generator; the block covers all of it")
      ->option_text("FILE")
      ->group(data);
  cli.add_option("--vertical-unit", verticalUnit, "Unit of its heights: m, ft, dm, 0.1, ... (default: the file's)")
      ->option_text("UNIT")
      ->group(data);
  commandLine.addNumber("--posts", posts, 1e-6, 1e6, "Metres between its posts (default: as the file says)")
      ->group(data);
  cli.add_option("--fill", fill, "none, voids (from their surroundings)")
      ->check(CLI::IsMember({"none", "voids"}))
      ->option_text("WHAT")
      ->group(data);
  cli.add_option("--outside", outside, "Beyond the file: hole, clamp, or a height (default: hole)")
      ->option_text("WHAT")
      ->group(data);
  cli.add_flag("--native", native, "The file's own posts, centred on its highest")->group(data);

  commandLine.addNumber("--vertical-scale", verticalScale, 1e-6, 1e6, "Stretches heights (default: 1)")->group(view);
  cli.add_flag("--wireframe", wireframe, "Draw lines")->group(view);
  cli.add_flag("--parts", parts, "Patches, seams and corners in different colours")->group(view);
  cli.add_flag("--top", top, "Seen from straight above, north up")->group(view);
  commandLine.addNumber("--water", m_water, -huge, huge, "A sheet of water at this height, metres")
      ->option_text("LEVEL")
      ->group(view)
      ->each([this](const std::string&) { hasWater = true; });
  cli.add_option("--drape", drape, "PNG picture to lay over the block, north up")->option_text("IMAGE")->group(view);
  cli.add_option("--export", exportFile, "Write the terrain as an Inventor file of Coin's own nodes")
      ->option_text("OUT.iv")
      ->group(view);
}
