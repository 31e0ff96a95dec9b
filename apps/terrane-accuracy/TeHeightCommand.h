#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeHeightSweep.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

/// `terrane-accuracy height`: heights and rays by level: errors, what is said of them, time and memory.
class TeHeightCommand {
public:
  explicit TeHeightCommand(TeCommandLine& commandLine);

  CLI::App& cli() { return *m_cli; }
  /// Measures and writes height.csv, height.json and height.md. Returns the exit status.
  int run();

private:
  TeResult<TeMeasuredTerrain> land() const;
  void describe(const TeMeasuredTerrain& terrain, const TeHeightWorld& world,
                const std::vector<TeHeightFigures>& all, const TeTable& table,
                TeAccuracyOutput& output) const;

  TeCommandLine& m_commandLine;
  CLI::App* m_cli;
  TeTerrainChoice m_terrain;
  int m_samplesLog = 11;
  int m_levels = 7;
  int m_queries = 20000;
  int m_runs = 9;
  std::string m_folder = "accuracy";
};
