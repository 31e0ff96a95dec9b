#pragma once

#include "generators/elevation/TeRasterFile.h"

#include <gdal_priv.h>

#include <memory>
#include <string>

/// A raster file read by GDAL.
class TeGdalRasterFile final : public TeRasterFile {
public:
  /// Bytes of decoded samples that one block of the file may have (all its bands together).
  static constexpr std::int64_t kMaxBlockBytes = std::int64_t(128) << 20;

  static TeResult<std::unique_ptr<TeRasterFile>> open(const std::string& path, const std::string& driver,
                                                      const std::string& variable, int band);

  TeStatus read(int band, TeRasterWindow window, double* samples) override;
  std::shared_ptr<const TeMapProjection> projection() const override { return m_projection; }

private:
  TeStatus describe(int number);
  TeStatus checkBlocks(GDALRasterBand& band) const;
  void describeSystem();

  GDALDatasetUniquePtr m_dataset;
  std::shared_ptr<const TeMapProjection> m_projection;
};
