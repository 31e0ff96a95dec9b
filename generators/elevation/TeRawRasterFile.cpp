#include "generators/elevation/TeRawRasterFile.h"

#include <utility>

TeRawRasterFile::TeRawRasterFile(TePlainFile file, const TeElevationOptions& options)
    : m_file(std::move(file)), m_bigEndian(options.rawBigEndian) {
  m_info.format = "raw";
  m_info.columns = options.rawColumns;
  m_info.rows = options.rawRows;
  m_info.bands = 1;
  m_info.pixelIsPoint = true;
  m_info.signed16 = options.rawSigned;
  m_info.unsigned16 = !options.rawSigned;
}

TeResult<std::unique_ptr<TeRasterFile>> TeRawRasterFile::open(const std::string& path,
                                                              const TeElevationOptions& options) {
  TeResult<TePlainFile> file = TePlainFile::open(path);
  if (!file)
    return file.error();
  const std::uint64_t wanted = 2 * std::uint64_t(options.rawColumns) * std::uint64_t(options.rawRows);
  if (file->bytes() != wanted)
    return TeError{path + ": " + std::to_string(file->bytes()) + " bytes, but " +
                   std::to_string(options.rawColumns) + "x" + std::to_string(options.rawRows) +
                   " samples of 16 bits are " + std::to_string(wanted)};
  return std::unique_ptr<TeRasterFile>(new TeRawRasterFile(std::move(*file), options));
}

TeStatus TeRawRasterFile::read(int, TeRasterWindow window, double* samples) {
  m_row.resize(2 * std::size_t(window.columns));
  for (int r = 0; r < window.rows; ++r) {
    const std::uint64_t first = std::uint64_t(window.row + r) * m_info.columns + window.column;
    if (TeStatus ok = m_file.read(2 * first, m_row.data(), m_row.size()); !ok)
      return ok;
    for (int c = 0; c < window.columns; ++c) {
      const unsigned a = m_row[2 * std::size_t(c)];
      const unsigned b = m_row[2 * std::size_t(c) + 1];
      const unsigned bits = m_bigEndian ? a << 8 | b : b << 8 | a;
      samples[std::size_t(r) * window.columns + c] =
          m_info.signed16 && bits >= 0x8000 ? int(bits) - 0x10000 : int(bits);
    }
  }
  return {};
}
