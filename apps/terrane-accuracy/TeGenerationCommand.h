#pragma once

#include "apps/terrane-accuracy/TeAccuracyCommand.h"
#include "apps/terrane-accuracy/TeGenerationSweep.h"

/// `terrane-accuracy generation`: what better maps cost, generator by generator.
class TeGenerationCommand : public TeAccuracyCommand {
public:
  explicit TeGenerationCommand(TeCommandLine& commandLine);

private:
  TeResult<TeTable> measure(TeAccuracyOutput& output) override;
  static void addRow(const TeGenerationFigures& figures, TeTable& table);
  void describe(const std::vector<TeGenerationFigures>& figures, const TeTable& table,
                TeAccuracyOutput& output) const;

  std::vector<std::string> m_generators;
  int m_samplesLog = 8;
  TeGenerationEffort m_effort;
};
