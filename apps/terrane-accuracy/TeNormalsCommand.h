#pragma once

#include "apps/terrane-accuracy/TeAccuracyCommand.h"
#include "apps/terrane-accuracy/TeNormalsSweep.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

/// `terrane-accuracy normals`: angle errors of normals by way and level, and what they cost.
class TeNormalsCommand : public TeAccuracyCommand {
public:
  explicit TeNormalsCommand(TeCommandLine& commandLine);

private:
  using Plots = std::vector<std::pair<std::string, TePlot>>; ///< by suffix of their files

  TeStatus read() override;
  TeResult<TeTable> measure(TeAccuracyOutput& output) override;
  int samples() const { return (1 << m_samplesLog) + 1; }
  void measureOn(const TeNormalsTerrain& terrain, TeTable& table, std::string& words, Plots& plots) const;

  TeTerrainChoice m_choice;
  int m_samplesLog = 9;
  int m_levels = 6;
  int m_runs = 9;
  // The middle of the chosen terrain.
  std::string m_name;
  std::optional<TeHeightMap> m_map; ///< metres
  double m_spacing = 1;
};
