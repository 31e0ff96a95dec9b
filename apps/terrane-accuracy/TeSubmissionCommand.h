#pragma once

#include "apps/terrane-accuracy/TeAccuracyCommand.h"
#include "apps/terrane-accuracy/TeSubmissionSweep.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

/// `terrane-accuracy submission`: the same meshes sent in each of document 003's ways.
class TeSubmissionCommand : public TeAccuracyCommand {
public:
  explicit TeSubmissionCommand(TeCommandLine& commandLine);

private:
  TeStatus read() override;
  TeResult<TeTable> measure(TeAccuracyOutput& output) override;
  int frames() const { return framesOr(kDefaultFrames); }
  TeResult<std::vector<TeSubmissionMesh>> meshes() const;
  TeStatus sendAll(TeFlightStage& stage, TeTable& table) const;
  void describe(const TeFlightStage& stage, const TeTable& table, TeAccuracyOutput& output) const;

  static constexpr int kDefaultFrames = 11;

  TeTerrainChoice m_choice;
  std::string m_method = "seamless";
  std::vector<double> m_pixels{1, 4};
  int m_largest = 512;
  std::optional<TeMeasuredTerrain> m_terrain;
  std::optional<std::vector<TeSubmissionMesh>> m_meshes;
};
