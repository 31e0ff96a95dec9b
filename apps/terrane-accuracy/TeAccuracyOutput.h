#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/common/TeReport.h"
#include "apps/terrane-accuracy/TePlot.h"
#include "apps/terrane-accuracy/TeTable.h"

#include <string>

/// Where a sub-command writes what it has measured: NAME.csv, NAME.json, NAME.md and diagrams in one folder.
class TeAccuracyOutput {
public:
  TeAccuracyOutput(const TeCommandLine& commandLine, std::string name, std::string folder);

  /// For the JSON object, beside "rows".
  nlohmann::ordered_json& json() { return m_report.json(); }
  /// A paragraph of the Markdown section, after its heading.
  void addText(const std::string& paragraph) { m_text += paragraph + "\n\n"; }
  /// A table in the Markdown section, which is printed, too, unless --quiet.
  void addTable(const TeTable& table);
  /// Draws NAME_<suffix>.svg and .png, and shows it in the Markdown section. Where that is not possible (no
  /// gnuplot) the section goes without, and one line on standard error says why.
  void addPlot(const TePlot& plot, const std::string& suffix);

  /// Writes the table and all else; creates the folder. Error: a file that cannot be written.
  TeStatus write(const TeTable& table);
  /// Makes sure that the folder can be written to, before long work begins.
  TeStatus prepare();

private:
  std::string path(const std::string& suffix) const { return m_folder + "/" + m_name + suffix; }

  const TeCommandLine& m_commandLine;
  TeReport m_report;
  std::string m_name;
  std::string m_folder;
  std::string m_text;
};
