#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeLodRun.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

#include <string>
#include <vector>

/// `terrane-accuracy lod`: what each method's accuracy costs on a flight, and whether it is reached.
class TeLodCommand {
public:
  explicit TeLodCommand(TeCommandLine& commandLine);

  CLI::App& cli() { return *m_cli; }
  /// Measures and writes lod.csv, lod.json, lod.md and diagrams. Returns the exit status.
  int run();

private:
  TeLodSettings settings() const;

  TeCommandLine& m_commandLine;
  CLI::App* m_cli;
  TeTerrainChoice m_terrain;
  TeLodSettings m_settings;
  bool m_flyover = true;
  bool m_geomorph = false;
  std::vector<double> m_pixels;
  std::vector<std::string> m_dials;
  bool m_noDraw = false;
  std::string m_folder = "accuracy";
};
