#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeLodTable.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

#include <memory>
#include <string>
#include <vector>

/// `terrane-accuracy lod`: what each method's accuracy costs on a flight, and whether it is reached.
class TeLodCommand {
public:
  explicit TeLodCommand(TeCommandLine& commandLine);

  CLI::App& cli() { return *m_cli; }
  /// Measures and writes lod.csv, lod.json, lod.md and diagrams. Returns the exit status.
  int run();

private:
  static constexpr int kDefaultFrames = 72;

  /// One method with one layout, and how its curve is called.
  struct Candidate {
    std::unique_ptr<TeMeasuredMethod> method;
    std::string layout;
  };
  TeResult<std::vector<Candidate>> candidates(const TeMeasuredTerrain& terrain) const;
  std::vector<TeDial> dials() const;
  TeFlyover flight(const TeMeasuredTerrain& terrain) const;
  int frames() const {
    return m_commandLine.common().frames > 0 ? m_commandLine.common().frames : kDefaultFrames;
  }
  /// `stage` null: nothing is drawn.
  TeStatus measure(const TeMeasuredTerrain& terrain, const std::vector<Candidate>& candidates,
                   TeFlightStage* stage, TeLodTable& table) const;
  void describe(const TeMeasuredTerrain& terrain, const TeFlightStage* stage, const TeLodTable& table,
                TeAccuracyOutput& output) const;

  TeCommandLine& m_commandLine;
  CLI::App* m_cli;
  TeTerrainChoice m_terrain;
  bool m_flyover = true;
  std::vector<std::string> m_methods = {"seamless"};
  std::vector<std::string> m_layouts = {"16/3"};
  std::vector<double> m_pixels;
  std::vector<double> m_precisions;
  int m_stride = 1;
  bool m_noDraw = false;
  std::string m_folder = "accuracy";
};
