#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeAccuracyPage.h"
#include "apps/terrane-accuracy/TeTable.h"
#include "apps/terrane-accuracy/TeTerrainChoice.h"

#include <string>
#include <vector>

/// `terrane-accuracy all`: every other sub-command over one terrain, and one page of it all.
class TeAllCommand {
public:
  /// The program itself, asked for other sub-commands.
  using Program = int (*)(int argc, char** argv);

  TeAllCommand(TeCommandLine& commandLine, Program program);

  CLI::App& cli() { return *m_cli; }
  /// Writes accuracy.md with diagrams and tables. Returns the exit status: a failure if a part has failed,
  /// which the page then lacks.
  int run();

private:
  struct Part {
    std::string name;
    std::string heading;
    std::vector<std::string> arguments;
    std::vector<std::string> columns; ///< of its table that the page shows; empty: all
  };

  TeResult<TeMeasuredTerrain> land() const;
  /// Where the terrain is written for all parts.
  std::string mapFile(const TeMeasuredTerrain& terrain) const;
  std::vector<Part> parts(const TeMeasuredTerrain& terrain) const;
  int runPart(const Part& part) const;
  void introduce(const TeMeasuredTerrain& terrain, TeAccuracyPage& page) const;

  TeCommandLine& m_commandLine;
  Program m_program;
  CLI::App* m_cli;
  TeTerrainChoice m_terrain;
  int m_samplesLog = 10;
  bool m_quick = false;
  bool m_noDraw = false;
  std::string m_folder = "docs";
  std::string m_work = "accuracy";
};
