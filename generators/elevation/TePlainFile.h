#pragma once

#include "generators/base/TeResult.h"

#include <cstddef>
#include <cstdint>
#include <string>

/// A plain file open for reading by position. A damaged medium is an error and no signal, as it would be with
/// a mapped file. Move-only; reading is thread-safe.
class TePlainFile {
public:
  /// Error: missing, not readable, or no plain file; never waits, as opening a pipe would.
  static TeResult<TePlainFile> open(const std::string& path);

  TePlainFile(TePlainFile&& other) noexcept;
  TePlainFile& operator=(TePlainFile&& other) noexcept;
  ~TePlainFile();

  /// Size when it was opened.
  std::uint64_t bytes() const { return m_bytes; }
  /// Reads exactly `count` bytes from `offset` on. Error: beyond the end, or unreadable.
  TeStatus read(std::uint64_t offset, void* data, std::size_t count) const;

private:
  TePlainFile(std::string path, int descriptor, std::uint64_t bytes);

  std::string m_path;
  int m_descriptor = -1;
  std::uint64_t m_bytes = 0;
};
