#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeGenerationSweep.h"

/// `terrane-accuracy generation`: what better maps cost, generator by generator.
class TeGenerationCommand {
public:
  explicit TeGenerationCommand(TeCommandLine& commandLine);

  CLI::App& cli() { return *m_cli; }
  /// Measures and writes generation.csv, generation.json and generation.md. Returns the exit status.
  int run();

private:
  static void addRow(const TeGenerationFigures& figures, TeTable& table);
  void describe(const std::vector<TeGenerationFigures>& figures, const TeTable& table,
                TeAccuracyOutput& output) const;

  TeCommandLine& m_commandLine;
  CLI::App* m_cli;
  std::vector<std::string> m_generators;
  int m_samplesLog = 8;
  TeGenerationEffort m_effort;
  std::string m_folder = "accuracy";
};
