#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeInstancingSweep.h"

#include <optional>
#include <string>
#include <vector>

/// `terrane-accuracy instancing`: Table 6.1 of document 004 measured again, with what selection costs.
class TeInstancingCommand {
public:
  explicit TeInstancingCommand(TeCommandLine& commandLine);

  CLI::App& cli() { return *m_cli; }
  /// Measures and writes instancing.csv, instancing.json and instancing.md. Returns the exit status.
  int run();

private:
  TeResult<TeInstancingTerrain> open() const;
  TeFlyover flight(const TeInstancingTerrain& terrain) const;
  int frames() const;
  /// Resolutions to be measured, the terrain's own first; only that is drawn.
  std::vector<int> resolutions(const TeInstancingTerrain& terrain) const;
  static void addRow(TeInstancingWay way, int resolution, double precision, const TeSelectionFigures& chosen,
                     const std::optional<TeByWay<TeDrawingFigures>>& drawn, TeTable& table);
  TeStatus measure(const TeInstancingTerrain& terrain, TeFlightStage* stage, TeTable& table) const;
  void describe(const TeInstancingTerrain& terrain, const TeFlightStage* stage, const TeTable& table,
                TeAccuracyOutput& output) const;

  TeCommandLine& m_commandLine;
  CLI::App* m_cli;
  std::string m_clipmaps;
  std::string m_map;
  double m_cells = 10;
  double m_heightUnit = 0.1;
  int m_clipSize = 513;
  int m_minResolution = 16;
  int m_levels = 3;
  std::vector<double> m_precisions = {1, 4};
  bool m_noDraw = false;
  std::string m_folder = "accuracy";
};
