#include "apps/terrane-static/TeStaticOptions.h"

void TeStaticOptions::addTo(TeCommandLine& commandLine) {
  commandLine.addInteger("--block", block, 1, kMaxBlock, "Patches a side (default: 3)")->group("Terrain");
  commandLine.addPoint("--center", center, "A point of the middle patch, metres (default: 0,0)")
      ->group("Terrain");
  terrain.addTo(commandLine);
  addView(commandLine);
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
