#pragma once

#include "generators/base/TeResult.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// A file that appears under its name whole or not at all: it is written as `NAME.part` and moved into place
/// when all of it is on the disk. A part that is not finished stays behind, so that work can go on with it
/// later; a file under the name itself is left alone until then. Errors name the file. Move-only.
class TePartFile {
public:
  /// keep: bytes of an earlier part that are kept; the rest of it is cut off. Error: cannot be written, no
  /// plain file, shorter than `keep`, or another process is writing it (on file systems that can tell).
  static TeResult<TePartFile> open(const std::string& path, std::uint64_t keep = 0);
  /// The whole file at once.
  static TeStatus writeWhole(const std::string& path, const std::string& contents);
  static std::string partOf(const std::string& path) { return path + ".part"; }

  TePartFile(TePartFile&& other) noexcept;
  TePartFile& operator=(TePartFile&& other) noexcept;
  ~TePartFile();

  /// Bytes written so far, kept ones included.
  std::uint64_t bytes() const { return m_written + m_buffer.size(); }
  TeStatus write(const void* data, std::size_t count);
  /// What was written is on the disk afterwards.
  TeStatus flush();
  /// Moves the file into place, where it replaces another; nothing is written after that.
  TeStatus finish();
  /// Removes the part instead.
  void discard();

private:
  TePartFile(std::string path, int descriptor, std::uint64_t written)
      : m_path(std::move(path)), m_descriptor(descriptor), m_written(written) {}
  TeStatus writeBuffer();
  TeError failure(const std::string& path) const;

  static constexpr std::size_t kBufferBytes = std::size_t(1) << 17;

  std::string m_path;
  int m_descriptor = -1;
  std::uint64_t m_written = 0;
  bool m_changed = false; ///< since the last flush()
  std::vector<char> m_buffer;
};

/// Makes names that were given to files in the file's folder last. Best effort: not all file systems can.
void teSyncFolderOf(const std::string& path);
