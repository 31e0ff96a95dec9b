#pragma once

#include "generators/base/TeResult.h"

#include <string>
#include <vector>

/// One page of the sections that sub-commands have written, with its diagrams in images/accuracy/ beside it
/// and its tables in accuracy/.
class TeAccuracyPage {
public:
  /// `work`: where the sections lie. `folder`: where accuracy.md is to be.
  TeAccuracyPage(std::string work, std::string folder)
      : m_work(std::move(work)), m_folder(std::move(folder)) {}

  void addText(const std::string& paragraph) { m_text += paragraph + "\n\n"; }
  /// What a sub-command has written, and what of it is to be on the page.
  struct Section {
    std::string name;
    std::string heading;
    std::vector<std::string> columns{}; ///< of tables that have all of these no others are shown; empty: all
    std::vector<std::string> runs{};    ///< rows of NAME.csv, by their first cell; empty: all
  };
  /// NAME.md under its heading, with the diagrams that it shows and NAME.csv copied. Error: a file that
  /// cannot be read or written.
  TeStatus addSection(const Section& section);
  /// Error: a file that cannot be written.
  TeStatus write() const;

private:
  TeStatus copy(const std::string& file, const std::string& folder) const;
  TeStatus copyTable(const Section& section) const;

  std::string m_work;
  std::string m_folder;
  std::string m_text;
};
