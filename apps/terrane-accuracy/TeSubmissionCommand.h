#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeSubmissionSweep.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

#include <string>
#include <vector>

/// `terrane-accuracy submission`: the same meshes sent in each of document 003's ways.
class TeSubmissionCommand {
public:
  explicit TeSubmissionCommand(TeCommandLine& commandLine);

  CLI::App& cli() { return *m_cli; }
  /// Measures and writes submission.csv, submission.json, submission.md and diagrams. Returns the exit
  /// status.
  int run();

private:
  int frames() const;
  TeResult<std::vector<TeSubmissionMesh>> meshes(const TeMeasuredTerrain& terrain) const;
  TeStatus measure(const std::vector<TeSubmissionMesh>& meshes, TeFlightStage& stage, TeTable& table) const;
  void describe(const TeMeasuredTerrain& terrain, const TeFlightStage& stage, const TeTable& table,
                TeAccuracyOutput& output) const;

  TeCommandLine& m_commandLine;
  CLI::App* m_cli;
  TeTerrainChoice m_terrain;
  std::string m_method = "seamless";
  std::vector<double> m_pixels{1, 4};
  int m_largest = 512;
  std::string m_folder = "accuracy";
};
