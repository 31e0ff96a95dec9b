#pragma once

#include "apps/terrane-bake/TeRows.h"
#include "generators/elevation/TePostDecoder.h"
#include "generators/elevation/TeRasterFile.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The stored numbers of an elevation file, or the channels of a picture, in the order of the file's rows.
/// Reads some rows at a time, at most 4 MB of numbers.
class TeRasterRows final : public TeRows {
public:
  /// The channels are bands band, band + 1, … `fill` takes the place of what the decoder takes for missing.
  TeRasterRows(std::string path, std::unique_ptr<TeRasterFile> raster, int band, int channels,
               const TePostDecoder& decoder, std::optional<double> fill);

  TeStatus read(int row, double* numbers) override;

private:
  TeStatus readBlock(int firstRow);

  static constexpr int kBlockNumbers = 1 << 18;

  std::string m_path;
  std::unique_ptr<TeRasterFile> m_raster;
  int m_band;
  TePostDecoder m_decoder;
  double m_fill; ///< NaN if there is none
  int m_blockRows;
  int m_firstRow = -1;         ///< of the block in memory
  std::vector<double> m_block; ///< channel by channel
};
