#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeQualityFlight.h"

#include <string>
#include <vector>

/// `terrane-accuracy quality`: how TeQuality holds a frame-time goal under a load that changes in steps, over
/// a flight that is drawn and in a simulation.
class TeQualityCommand {
public:
  explicit TeQualityCommand(TeCommandLine& commandLine);

  CLI::App& cli() { return *m_cli; }
  /// Measures and writes quality.csv, quality.json, quality.md and diagrams. Returns the exit status.
  int run();

private:
  /// None is drawn with --no-draw.
  TeResult<std::vector<TeQualityTrace>> traces(TeAccuracyOutput& output) const;
  TeResult<TeQualityTrace> drawn(TeAccuracyOutput& output) const;
  static TeTable tableOf(const std::vector<TeQualityTrace>& traces);
  static TeTable summaryOf(const std::vector<TeQualityTrace>& traces);
  static void addPlots(const TeQualityTrace& trace, const std::string& suffix, TeAccuracyOutput& output);

  TeCommandLine& m_commandLine;
  CLI::App* m_cli;
  int m_radius = 6;
  double m_rate = 0; ///< frames a second; 0 = one that can be held
  double m_load = 2;
  double m_seconds = 4; ///< a step
  bool m_noDraw = false;
  std::string m_folder = "accuracy";
};
