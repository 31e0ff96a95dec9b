#include "apps/terrane-accuracy/TeAccuracyOutput.h"

#include "generators/base/TePartFile.h"

#include <cstdio>
#include <filesystem>

TeAccuracyOutput::TeAccuracyOutput(const TeCommandLine& commandLine, std::string name, std::string folder)
    : m_commandLine(commandLine), m_report(commandLine.application(), commandLine.commandText()),
      m_name(std::move(name)), m_folder(std::move(folder)) {}

TeStatus TeAccuracyOutput::prepare() {
  std::error_code error;
  std::filesystem::create_directories(m_folder, error);
  if (error)
    return TeError{m_folder + ": cannot be made: " + error.message()};
  TeResult<TePartFile> file = TePartFile::open(path(".csv")); // what an earlier run wrote stays for now
  if (!file)
    return file.error();
  file->discard();
  return {};
}

void TeAccuracyOutput::addTable(const TeTable& table) {
  const std::string text = table.markdown();
  addText(text);
  if (!m_commandLine.common().quiet)
    std::fputs(text.c_str(), stdout);
}

void TeAccuracyOutput::addPlot(const TePlot& plot, const std::string& suffix) {
  if (const TeStatus ok = plot.write(path("_" + suffix)); !ok) {
    if (!m_commandLine.common().quiet)
      std::fprintf(stderr, "%s: %s\n", m_commandLine.application().c_str(), ok.error().message.c_str());
    return;
  }
  addText("![" + plot.title + "](" + m_name + "_" + suffix + ".svg)");
}

TeStatus TeAccuracyOutput::write(const TeTable& table) {
  m_report.json()["rows"] = table.json();
  if (const TeStatus ok = TePartFile::writeWhole(path(".csv"), table.csv()); !ok)
    return ok;
  if (const TeStatus ok = TePartFile::writeWhole(path(".md"), "## " + m_name + "\n\n" + m_text); !ok)
    return ok;
  if (const std::string& report = m_commandLine.common().report; !report.empty())
    if (const TeStatus ok = m_report.write(report); !ok)
      return ok;
  return m_report.write(path(".json"));
}
