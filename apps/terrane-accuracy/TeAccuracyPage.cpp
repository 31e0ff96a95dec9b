#include "apps/terrane-accuracy/TeAccuracyPage.h"

#include "generators/base/TePartFile.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

namespace fs = std::filesystem;

/// The file that a line `![title](file)` shows; empty for other lines.
std::string shownBy(const std::string& line) {
  const std::size_t middle = line.find("](");
  if (line.rfind("![", 0) != 0 || middle == std::string::npos || line.back() != ')')
    return {};
  return line.substr(middle + 2, line.size() - middle - 3);
}

/// The cells of a line `| a | b |`.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');)
    cells.push_back(cell);
  return cells;
}

/// Of a line of CSV.
std::string firstCellOf(const std::string& line) {
  return line[0] == '"' ? line.substr(1, line.find('"', 1) - 1) : line.substr(0, line.find(','));
}

/// Leaves only some columns of tables.
class Columns {
public:
  explicit Columns(const std::vector<std::string>& wanted) : m_wanted(wanted) {}

  std::string shown(const std::string& line) {
    if (line.rfind('|', 0) != 0) {
      m_inTable = false;
      return line;
    }
    const std::vector<std::string> cells = cellsOf(line);
    if (!m_inTable)
      begin(cells);
    m_inTable = true;
    if (m_places.empty())
      return line;
    std::string text = "|";
    for (const std::size_t place : m_places)
      text += (place < cells.size() ? cells[place] : std::string()) + '|';
    return text;
  }

private:
  void begin(const std::vector<std::string>& names) {
    m_places.clear();
    for (const std::string& column : m_wanted) {
      const auto found = std::find(names.begin(), names.end(), ' ' + column + ' ');
      if (found == names.end())
        return m_places.clear();
      m_places.push_back(std::size_t(found - names.begin()));
    }
  }

  const std::vector<std::string>& m_wanted;
  std::vector<std::size_t> m_places; ///< none: all
  bool m_inTable = false;
};

} // namespace

TeStatus TeAccuracyPage::copy(const std::string& file, const std::string& folder) const {
  std::error_code error;
  fs::create_directories(fs::path(m_folder) / folder, error);
  if (!error)
    fs::copy_file(fs::path(m_work) / file, fs::path(m_folder) / folder / file,
                  fs::copy_options::overwrite_existing, error);
  if (error)
    return TeError{(fs::path(m_folder) / folder / file).string() + ": cannot be written: " + error.message()};
  return {};
}

TeStatus TeAccuracyPage::copyTable(const Section& section) const {
  const std::string file = section.name + ".csv";
  if (const TeStatus ok = copy(file, "accuracy"); !ok || section.runs.empty())
    return ok;
  std::ifstream stream(fs::path(m_work) / file);
  std::string line;
  std::getline(stream, line);
  std::string text = line + "\n";
  while (std::getline(stream, line))
    if (std::find(section.runs.begin(), section.runs.end(), firstCellOf(line)) != section.runs.end())
      text += line + "\n";
  return TePartFile::writeWhole((fs::path(m_folder) / "accuracy" / file).string(), text);
}

TeStatus TeAccuracyPage::addSection(const Section& section) {
  const std::string& name = section.name;
  const fs::path file = fs::path(m_work) / (name + ".md");
  std::ifstream stream(file);
  if (!stream)
    return TeError{file.string() + ": cannot be read"};
  std::string text = "## " + section.heading + "\n\n";
  Columns chosen(section.columns);
  for (std::string line; std::getline(stream, line);) {
    const bool blankAgain = line.empty() && text.substr(text.size() - 2) == "\n\n";
    if (line == "## " + name || blankAgain)
      continue;
    // Files are named, but no folders of this machine.
    for (std::size_t at; (at = line.find(m_work + "/")) != std::string::npos;)
      line.erase(at, m_work.size() + 1);
    if (const std::string shown = shownBy(line); !shown.empty()) {
      if (const TeStatus ok = copy(shown, "images/accuracy"); !ok)
        return ok;
      line.insert(line.size() - shown.size() - 1, "images/accuracy/");
    }
    text += chosen.shown(line) + "\n";
  }
  if (const TeStatus ok = copyTable(section); !ok)
    return ok;
  if (text.substr(text.size() - 2) != "\n\n")
    text += "\n";
  m_text += text + (section.runs.empty() ? "All figures: [" : "Figures of the runs in the diagrams: [") +
            name + ".csv](accuracy/" + name + ".csv).\n\n";
  return {};
}

TeStatus TeAccuracyPage::write() const {
  std::error_code error;
  fs::create_directories(m_folder, error);
  if (error)
    return TeError{m_folder + ": cannot be made: " + error.message()};
  std::string text = m_text;
  while (text.size() > 1 && text.substr(text.size() - 2) == "\n\n")
    text.pop_back();
  return TePartFile::writeWhole((fs::path(m_folder) / "accuracy.md").string(), text);
}
