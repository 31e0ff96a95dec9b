#include "generators/elevation/TeGdal.h"
#include "generators/elevation/modules/TeGdalErrors.h"
#include "generators/elevation/modules/TeGdalProjection.h"
#include "generators/elevation/modules/TeGdalRasterFile.h"

#include <cpl_conv.h>
#include <gdal_alg.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>

#include <exception>
#include <vector>

namespace {

constexpr GIntBig kBlockCacheBytes = GIntBig(64) << 20;

/// A float raster in the caller's memory.
GDALDatasetUniquePtr memoryRaster(void* samples, int columns, int rows, GDALDataType type) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  if (!driver)
    return nullptr;
  GDALDatasetUniquePtr dataset(driver->Create("", columns, rows, 0, type, nullptr));
  if (!dataset)
    return nullptr;
  char address[64] = {};
  address[CPLPrintPointer(address, samples, sizeof address - 1)] = 0;
  const std::string pointer = std::string("DATAPOINTER=") + address;
  char* options[] = {const_cast<char*>(pointer.c_str()), nullptr};
  if (dataset->AddBand(type, options) != CE_None)
    return nullptr;
  return dataset;
}

class GdalModule final : public TeGdal {
public:
  GdalModule() {
    const TeGdalErrors errors;
    // Only what teRasterFormat() can choose, and rasters in memory for the filling of voids.
    for (void (*registerDriver)() :
         {GDALRegister_GTiff, GDALRegister_PNG, GDALRegister_BT, GDALRegister_netCDF, GDALRegister_SRTMHGT,
          GDALRegister_AAIGrid, GDALRegister_USGSDEM, GDALRegister_MEM})
      registerDriver();
    OSRSetPROJEnableNetwork(false);
    if (GDALGetCacheMax64() > kBlockCacheBytes)
      GDALSetCacheMax64(kBlockCacheBytes);
  }

  TeResult<std::unique_ptr<TeRasterFile>> open(const std::string& path, const std::string& driver,
                                               const std::string& variable, int band) const override {
    // GDAL's own code may throw on what a hostile file makes it ask for.
    try {
      return TeGdalRasterFile::open(path, driver, variable, band);
    } catch (const std::exception& e) {
      return TeError{path + ": GDAL gave up: " + e.what()};
    }
  }

  TeStatus fillVoids(float* heights, int columns, int rows, int distance) const override {
    const TeGdalErrors errors;
    const std::size_t count = std::size_t(columns) * rows;
    std::vector<GByte> present(count);
    for (std::size_t i = 0; i < count; ++i)
      present[i] = heights[i] == heights[i] ? 255 : 0;
    const auto raster = memoryRaster(heights, columns, rows, GDT_Float32);
    const auto mask = memoryRaster(present.data(), columns, rows, GDT_Byte);
    if (!raster || !mask)
      return TeError{"filling voids: " + errors.first("out of memory")};
    char temporary[] = "TEMP_FILE_DRIVER=MEM";
    char* options[] = {temporary, nullptr};
    GDALRasterBand* maskBand = mask->GetRasterBand(1);
    const CPLErr result =
        GDALFillNodata(raster->GetRasterBand(1), maskBand, distance, 0, 0, options, nullptr, nullptr);
    if (result != CE_None || errors.failed())
      return TeError{"filling voids: " + errors.first("failed")};
    return {};
  }

  std::shared_ptr<const TeMapProjection> geographicDegrees() const override {
    return TeGdalProjection::degrees();
  }
};

} // namespace

extern "C" const TeGdal* teGdalModule() {
  static const GdalModule module;
  return &module;
}
