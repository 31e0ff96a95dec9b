#pragma once

#include "generators/base/TePartFile.h"
#include "nodes/clipmap/TePyramidFiles.h"
#include "nodes/clipmap/TePyramidJournal.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Which pyramid is written, and from what.
struct TePyramidPlan {
  std::string name;
  int level = 0;                 ///< the highest, 1 .. kTeHighestPyramidLevel
  int sampleBytes = 2;           ///< 1 .. 4
  std::uint64_t fingerprint = 0; ///< of all that the samples depend on
};

/// Writes the files of all levels (TePyramidFiles.h) in one pass over the rows of the highest. A file appears
/// under its name only when all of the pyramid is on the disk. What was begun and not finished is gone on
/// with if the fingerprint is the same; so the bytes are those of a run that was not interrupted.
/// `NAME.journal` tells what was begun.
///
/// Memory: a row and 128 KB a level. Error: a file cannot be written; named, with the reason. Move-only.
class TePyramidWriter {
public:
  /// Whether a new pyramid may be made without loss: error if there are files of levels of that name, unless
  /// they are of the same interrupted work, or interrupted work on something else.
  static TeStatus check(const TePyramidPlan& plan);

  static std::string journalOf(const TePyramidPlan& plan) { return plan.name + ".journal"; }

  /// Goes on with what was begun, or starts anew over whatever there is. Nothing under the names of levels
  /// changes before finish(). Error also: another program is at it.
  static TeResult<TePyramidWriter> open(const TePyramidPlan& plan);

  /// Row of the highest level that is to be written next; its side when all are.
  int nextRow() const { return m_row; }
  /// The next row, from the north: side · sampleBytes bytes.
  TeStatus write(const unsigned char* samples);
  /// When all rows are written: the files take their names. Files of higher levels of an older pyramid are
  /// removed. The journal stays until remembering is no more of use: forget().
  TeStatus finish();
  /// Removes the journal.
  void forget() { m_journal.remove(); }
  /// Removes what was written, before finish().
  void discard();

private:
  TePyramidWriter(const TePyramidPlan& plan, TePyramidJournal journal)
      : m_plan(plan), m_journal(std::move(journal)) {}
  bool resume();
  TeStatus begin();
  std::uint64_t bytesOfRows(int level, int rows) const;
  TeStatus checkpoint();

  static constexpr std::uint64_t kCheckpointBytes = std::uint64_t(16) << 20; ///< of the highest level

  TePyramidPlan m_plan;
  TePyramidJournal m_journal;
  int m_row = 0;
  int m_recordedRow = 0;
  /// By level; none where the file has its name already.
  std::vector<std::optional<TePartFile>> m_files;
  std::vector<unsigned char> m_halved; ///< the row at lower and lower levels
};
