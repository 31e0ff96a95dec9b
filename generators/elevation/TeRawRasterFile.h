#pragma once

#include "generators/elevation/TeElevationOptions.h"
#include "generators/elevation/TePlainFile.h"
#include "generators/elevation/TeRasterFile.h"

#include <vector>

/// Headerless 16 bit samples, rows from the north, columns from the west, without georeference; needs no
/// GDAL. Signed samples of -32768 are "no data".
class TeRawRasterFile final : public TeRasterFile {
public:
  /// The options' size, byte order and sign. Error: the file's size is not 2 · columns · rows bytes.
  static TeResult<std::unique_ptr<TeRasterFile>> open(const std::string& path,
                                                      const TeElevationOptions& options);

  TeStatus read(int band, TeRasterWindow window, double* samples) override;

private:
  TeRawRasterFile(TePlainFile file, const TeElevationOptions& options);

  TePlainFile m_file;
  bool m_bigEndian;
  std::vector<unsigned char> m_row;
};
