#pragma once

#include "apps/terrane-accuracy/TeAccuracyCommand.h"
#include "apps/terrane-accuracy/TeHeightSweep.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

/// `terrane-accuracy height`: heights and rays by level: errors, what is said of them, time and memory.
class TeHeightCommand : public TeAccuracyCommand {
public:
  explicit TeHeightCommand(TeCommandLine& commandLine);

private:
  TeStatus read() override;
  TeResult<TeTable> measure(TeAccuracyOutput& output) override;
  void describe(const std::vector<TeHeightFigures>& all, const TeTable& table,
                TeAccuracyOutput& output) const;

  TeTerrainChoice m_choice;
  int m_samplesLog = 11;
  int m_levels = 7;
  int m_queries = 20000;
  int m_runs = 9;
  std::optional<TeMeasuredTerrain> m_terrain;
  std::optional<TeHeightWorld> m_world; ///< of m_terrain
};
