#pragma once

#include "apps/terrane-accuracy/TeAccuracyCommand.h"
#include "apps/terrane-accuracy/TeAccuracyPage.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

/// `terrane-accuracy all`: every other sub-command over one terrain, and one page of it all: accuracy.md with
/// diagrams and tables. Parts that fail are not on the page.
class TeAllCommand : public TeAccuracyCommand {
public:
  /// The program itself, asked for other sub-commands.
  using Program = int (*)(int argc, char** argv);

  TeAllCommand(TeCommandLine& commandLine, Program program);

private:
  struct Part {
    TeAccuracyPage::Section section;
    std::vector<std::string> arguments;
  };

  TeStatus read() override;
  TeResult<TeTable> measure(TeAccuracyOutput& output) override;
  TeStatus finish() override;
  /// Where the terrain is written for all parts.
  std::string mapFile() const;
  std::vector<Part> parts() const;
  int runPart(const Part& part) const;
  void introduce(TeAccuracyPage& page) const;

  Program m_program;
  TeTerrainChoice m_choice;
  int m_samplesLog = 10;
  bool m_quick = false;
  std::string m_pageFolder = "docs";
  std::optional<TeMeasuredTerrain> m_terrain;
  std::optional<TeAccuracyPage> m_page;
  std::string m_failed; ///< names of parts
};
