#pragma once

#include "apps/terrane-accuracy/TeAccuracyCommand.h"
#include "apps/terrane-accuracy/TeQualityFlight.h"

/// `terrane-accuracy quality`: how TeQuality holds a frame-time goal under a load that changes in steps, over
/// a flight that is drawn and in a simulation.
class TeQualityCommand : public TeAccuracyCommand {
public:
  explicit TeQualityCommand(TeCommandLine& commandLine);

  /// Those runs of the table that have diagrams.
  static const std::vector<std::string>& shownRuns();

private:
  TeResult<TeTable> measure(TeAccuracyOutput& output) override;
  /// None is drawn with --no-draw.
  TeResult<std::vector<TeQualityTrace>> traces(TeAccuracyOutput& output) const;
  TeResult<TeQualityTrace> drawn(TeAccuracyOutput& output) const;
  static TeTable tableOf(const std::vector<TeQualityTrace>& traces);
  static TeTable summaryOf(const std::vector<TeQualityTrace>& traces);
  static void addPlots(const TeQualityTrace& trace, const std::string& suffix, TeAccuracyOutput& output);

  int m_radius = 6;
  double m_rate = 0; ///< frames a second; 0 = one that can be held
  double m_load = 2;
  double m_seconds = 4; ///< a step
};
