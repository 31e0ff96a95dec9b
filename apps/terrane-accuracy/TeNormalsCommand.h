#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeNormalsSweep.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

/// `terrane-accuracy normals`: angle errors of normals by way and level, and what they cost.
class TeNormalsCommand {
public:
  explicit TeNormalsCommand(TeCommandLine& commandLine);

  CLI::App& cli() { return *m_cli; }
  /// Measures and writes normals.csv, normals.json and normals.md. Returns the exit status.
  int run();

private:
  using Plots = std::vector<std::pair<std::string, TePlot>>; ///< by suffix of their files

  /// The middle of the chosen terrain in metres, or mountains where none is chosen.
  TeResult<TeHeightMap> land(std::string& name, double& spacing) const;
  void measure(const TeNormalsTerrain& terrain, TeTable& table, std::string& words, Plots& plots) const;

  TeCommandLine& m_commandLine;
  CLI::App* m_cli;
  TeTerrainChoice m_terrain;
  int m_samplesLog = 9;
  int m_levels = 6;
  int m_runs = 9;
  std::string m_folder = "accuracy";
};
