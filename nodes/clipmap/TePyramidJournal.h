#pragma once

#include "generators/base/TeResult.h"

#include <cstdint>
#include <string>

/// How far the writing of a pyramid has come, in a file beside it: a line that says what is being made, then
/// a line for every checkpoint; an incomplete last line does not count. While it is open no other process can
/// open it. Errors name the file. Move-only.
class TePyramidJournal {
public:
  struct State {
    bool exists = false;           ///< something was begun
    std::uint64_t fingerprint = 0; ///< of what is being made
    int rows = 0;                  ///< of the highest level that are on the disk
  };
  /// What a journal says; without one, or without its first line, nothing was begun. Error: unreadable, or no
  /// journal.
  static TeResult<State> read(const std::string& path);

  /// Opens a journal to go on with, without an incomplete last line, or an empty one. Error: cannot be written, or in use.
  static TeResult<TePyramidJournal> open(const std::string& path);

  TePyramidJournal(TePyramidJournal&& other) noexcept;
  TePyramidJournal& operator=(TePyramidJournal&& other) noexcept;
  ~TePyramidJournal();

  /// Forgets all and names what is being made now.
  TeStatus begin(std::uint64_t fingerprint);
  /// So many rows are on the disk; so is this line afterwards.
  TeStatus record(int rows);
  /// Deletes the file.
  void remove();

private:
  TePyramidJournal(std::string path, int descriptor) : m_path(std::move(path)), m_descriptor(descriptor) {}
  TeStatus append(const std::string& line);

  std::string m_path;
  int m_descriptor = -1;
};
