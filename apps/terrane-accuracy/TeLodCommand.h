#pragma once

#include "apps/terrane-accuracy/TeAccuracyCommand.h"
#include "apps/terrane-accuracy/TeLodRun.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

/// `terrane-accuracy lod`: what each method's accuracy costs on a flight, and whether it is reached.
class TeLodCommand : public TeAccuracyCommand {
public:
  explicit TeLodCommand(TeCommandLine& commandLine);

private:
  TeStatus read() override;
  TeResult<TeTable> measure(TeAccuracyOutput& output) override;
  TeLodSettings settings() const;

  TeTerrainChoice m_choice;
  TeLodSettings m_settings;
  bool m_flyover = true;
  std::vector<double> m_pixels;
  std::vector<std::string> m_dials;
  std::optional<TeLodRun> m_run;
};
