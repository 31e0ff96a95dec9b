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
  /// NAME.md under a heading of its own, with the diagrams that it shows and NAME.csv copied. Of tables that
  /// have all of `columns` only these are shown. Error: a file that cannot be read or written.
  TeStatus addSection(const std::string& name, const std::string& heading,
                      const std::vector<std::string>& columns = {});
  /// Error: a file that cannot be written.
  TeStatus write() const;

private:
  TeStatus copy(const std::string& file, const std::string& folder) const;

  std::string m_work;
  std::string m_folder;
  std::string m_text;
};
