#pragma once

#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeLodTable.h"

#include <functional>
#include <string>
#include <vector>

/// What `terrane-accuracy lod` is to measure.
struct TeLodSettings {
  /// A method's own dial in place of a wanted error.
  struct Dial {
    std::string method; ///< plain or with -geomorph; empty: of every method that has one
    double value = 0;
  };

  std::vector<std::string> methods; ///< empty: all of TeLodMethods
  bool geomorph = false;            ///< those that morph are measured in that form, too
  std::vector<std::string> layouts = {"16/3"};
  std::vector<double> pixels = {0.25, 0.5, 1, 2, 4, 8, 16, 32};
  std::vector<Dial> dials;
  TeMeasuredFrames frames{72, 1};
  int width = 1024;
  int height = 768;
};

/// Methods over one terrain and one flight: each at each wanted error and dial. Methods that draw everything,
/// however accurate that is to be, are measured once, as for an error of 0.
class TeLodRun {
public:
  /// Error: methods, layouts or dials that cannot be; one line.
  static TeResult<TeLodRun> create(TeMeasuredTerrain terrain, const TeLodSettings& settings);

  /// `stage` null: nothing is drawn. `progress` is told the share that is done. Error: one of OpenGL.
  TeStatus measure(TeFlightStage* stage, const std::function<void(double)>& progress);
  /// Writes terrain, flight, table and diagrams of what was measured into a section of its own; the caller
  /// writes table() by output.write().
  void describe(TeAccuracyOutput& output) const;
  const TeTable& table() const { return m_table.table(); }

private:
  TeLodRun(TeMeasuredTerrain terrain, const TeLodSettings& settings)
      : m_terrain(std::move(terrain)), m_settings(settings) {}
  TeStatus addCandidates();
  TeStatus checkDials() const;
  TeFlyover flight() const;
  std::vector<TeLodAccuracy> accuracies(const TeLodCandidate& candidate) const;

  TeMeasuredTerrain m_terrain;
  TeLodSettings m_settings;
  std::vector<TeLodCandidate> m_candidates;
  std::string m_renderer; ///< empty: nothing was drawn
  TeLodTable m_table;
};
