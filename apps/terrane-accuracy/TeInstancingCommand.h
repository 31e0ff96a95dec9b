#pragma once

#include "apps/terrane-accuracy/TeAccuracyCommand.h"
#include "apps/terrane-accuracy/TeInstancingSweep.h"

/// `terrane-accuracy instancing`: Table 6.1 of document 004 measured again, with what selection costs.
class TeInstancingCommand : public TeAccuracyCommand {
public:
  explicit TeInstancingCommand(TeCommandLine& commandLine);

private:
  TeStatus read() override;
  TeResult<TeTable> measure(TeAccuracyOutput& output) override;
  TeResult<TeInstancingTerrain> open() const;
  TeFlyover flight() const;
  int frames() const;
  /// Resolutions to be measured, the terrain's own first; only that is drawn.
  std::vector<int> resolutions() const;
  static void addRow(TeInstancingWay way, int resolution, double precision, const TeSelectionFigures& chosen,
                     const std::optional<TeByWay<TeDrawingFigures>>& drawn, TeTable& table);
  /// `stage` null: nothing is drawn.
  TeStatus fly(TeFlightStage* stage, TeTable& table) const;
  void describe(const TeFlightStage* stage, const TeTable& table, TeAccuracyOutput& output) const;

  std::string m_clipmaps;
  std::string m_map;
  double m_cells = 10;
  double m_heightUnit = 0.1;
  int m_clipSize = 513;
  int m_minResolution = 16;
  int m_levels = 3;
  std::vector<double> m_precisions = {1, 4};
  std::optional<TeInstancingTerrain> m_terrain;
};
