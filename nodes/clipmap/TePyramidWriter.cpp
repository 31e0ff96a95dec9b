#include "nodes/clipmap/TePyramidWriter.h"

#include "generators/base/TeHash.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cstring>

namespace {

/// The work's: also what lies on the disk.
std::uint64_t fingerprintOf(const TePyramidPlan& plan) {
  const std::uint64_t shape = std::uint64_t(plan.level) * 8 + std::uint64_t(plan.sampleBytes);
  return teHashCombine(plan.fingerprint, shape);
}

bool exists(const std::string& path) {
  struct stat status;
  return ::lstat(path.c_str(), &status) == 0;
}

bool hasBytes(const std::string& path, std::uint64_t bytes) {
  struct stat status;
  return ::lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
         std::uint64_t(status.st_size) == bytes;
}

} // namespace

TeStatus TePyramidWriter::check(const TePyramidPlan& plan) {
  const TeResult<TePyramidJournal::State> state = TePyramidJournal::read(journalOf(plan));
  if (!state)
    return state.error();
  if (state->exists && state->fingerprint == fingerprintOf(plan))
    return {};
  if (state->exists)
    return TeError{journalOf(plan) + ": tells of unfinished work on another source or with other options"};
  for (int level = 0; level <= kTeHighestPyramidLevel; ++level)
    if (const std::string file = tePyramidLevelFile(plan.name, level); exists(file))
      return TeError{file + ": exists already"};
  return {};
}

TeResult<TePyramidWriter> TePyramidWriter::open(const TePyramidPlan& plan) {
  assert(plan.level >= 1 && plan.level <= kTeHighestPyramidLevel && plan.sampleBytes >= 1 &&
         plan.sampleBytes <= 4);
  TeResult<TePyramidJournal> journal = TePyramidJournal::open(journalOf(plan));
  if (!journal)
    return journal.error();
  TePyramidWriter writer(plan, std::move(*journal));
  writer.m_halved.resize(std::size_t(tePyramidSide(plan.level)) * std::size_t(plan.sampleBytes));
  if (!writer.resume())
    if (TeStatus ok = writer.begin(); !ok)
      return ok.error();
  return writer;
}

std::uint64_t TePyramidWriter::bytesOfRows(int level, int rows) const {
  const int step = 1 << (m_plan.level - level);
  const std::uint64_t ofLevel = std::uint64_t((rows + step - 1) / step);
  return ofLevel * std::uint64_t(tePyramidSide(level)) * std::uint64_t(m_plan.sampleBytes);
}

/// False if nothing usable was begun.
bool TePyramidWriter::resume() {
  const TeResult<TePyramidJournal::State> state = TePyramidJournal::read(journalOf(m_plan));
  const int side = tePyramidSide(m_plan.level);
  if (!state || !state->exists || state->fingerprint != fingerprintOf(m_plan) || state->rows < 1 ||
      state->rows > side)
    return false;
  std::vector<std::optional<TePartFile>> files(std::size_t(m_plan.level) + 1);
  for (int level = 0; level <= m_plan.level; ++level) {
    const std::string path = tePyramidLevelFile(m_plan.name, level);
    const std::uint64_t bytes = bytesOfRows(level, state->rows);
    // Files take their names only after all rows are on the disk.
    if (state->rows == side && !exists(TePartFile::partOf(path)) && hasBytes(path, bytes))
      continue;
    TeResult<TePartFile> file = TePartFile::open(path, bytes);
    if (!file)
      return false;
    files[std::size_t(level)] = std::move(*file);
  }
  m_files = std::move(files);
  m_row = m_recordedRow = state->rows;
  return true;
}

TeStatus TePyramidWriter::begin() {
  // The journal first: parts that do not belong to it are gone before any of its lines speaks of rows.
  if (TeStatus ok = m_journal.begin(fingerprintOf(m_plan)); !ok)
    return ok;
  m_files.clear();
  m_files.resize(std::size_t(m_plan.level) + 1);
  m_row = m_recordedRow = 0;
  for (int level = 0; level <= m_plan.level; ++level) {
    TeResult<TePartFile> file = TePartFile::open(tePyramidLevelFile(m_plan.name, level));
    if (!file) {
      discard();
      return file.error();
    }
    m_files[std::size_t(level)] = std::move(*file);
  }
  for (int level = m_plan.level + 1; level <= kTeHighestPyramidLevel; ++level)
    ::unlink(TePartFile::partOf(tePyramidLevelFile(m_plan.name, level)).c_str());
  return {};
}

TeStatus TePyramidWriter::write(const unsigned char* samples) {
  const int top = m_plan.level;
  assert(m_row < tePyramidSide(top));
  const std::size_t bytes = std::size_t(m_plan.sampleBytes);
  const unsigned char* row = samples;
  for (int level = top; level >= 0 && m_row % (1 << (top - level)) == 0; --level) {
    const int side = tePyramidSide(level);
    if (level < top) {
      for (int x = 0; x < side; ++x)
        std::memmove(&m_halved[std::size_t(x) * bytes], row + 2 * std::size_t(x) * bytes, bytes);
      row = m_halved.data();
    }
    if (TeStatus ok = m_files[std::size_t(level)]->write(row, std::size_t(side) * bytes); !ok)
      return ok;
  }
  ++m_row;
  if (bytesOfRows(top, m_row) - bytesOfRows(top, m_recordedRow) >= kCheckpointBytes)
    return checkpoint();
  return {};
}

TeStatus TePyramidWriter::checkpoint() {
  for (std::optional<TePartFile>& file : m_files)
    if (file)
      if (TeStatus ok = file->flush(); !ok)
        return ok;
  if (m_recordedRow == m_row)
    return {};
  m_recordedRow = m_row;
  return m_journal.record(m_row);
}

TeStatus TePyramidWriter::finish() {
  assert(m_row == tePyramidSide(m_plan.level));
  if (TeStatus ok = checkpoint(); !ok)
    return ok;
  for (int level = m_plan.level + 1; level <= kTeHighestPyramidLevel; ++level)
    ::unlink(tePyramidLevelFile(m_plan.name, level).c_str());
  for (std::optional<TePartFile>& file : m_files)
    if (file)
      if (TeStatus ok = file->finish(); !ok)
        return ok;
  return {};
}

void TePyramidWriter::discard() {
  for (std::optional<TePartFile>& file : m_files)
    if (file)
      file->discard();
  forget();
}
