#include "generators/elevation/modules/TeGdalRasterFile.h"

#include "generators/elevation/modules/TeGdalErrors.h"
#include "generators/elevation/modules/TeGdalProjection.h"

#include <cpl_string.h>

#include <cmath>
#include <exception>

namespace {

/// netCDF files often say "degrees_east" of a variable and nothing of a coordinate system.
bool namesDegrees(char** metadata) {
  for (char** entry = metadata; entry && *entry; ++entry) {
    const std::string text = *entry;
    const std::size_t equals = text.find('=');
    if (text.find("#units=degrees_east") != std::string::npos ||
        text.find("#units=degree_east") != std::string::npos)
      return equals != std::string::npos;
  }
  return false;
}

/// The variables of a netCDF file, for a message.
std::string subdatasets(GDALDataset& dataset) {
  std::string names;
  char** metadata = dataset.GetMetadata("SUBDATASETS");
  for (int i = 1; i <= 20; ++i) {
    const char* name = CSLFetchNameValue(metadata, ("SUBDATASET_" + std::to_string(i) + "_NAME").c_str());
    if (!name)
      break;
    const std::string text = name;
    names += (names.empty() ? "" : ", ") + text.substr(text.rfind(':') + 1);
  }
  return names;
}

} // namespace

TeResult<std::unique_ptr<TeRasterFile>> TeGdalRasterFile::open(const std::string& path,
                                                               const std::string& driver,
                                                               const std::string& variable, int band) {
  const TeGdalErrors errors;
  const char* const drivers[] = {driver.c_str(), nullptr};
  std::string name = path;
  if (!variable.empty()) {
    if (driver != "netCDF")
      return TeError{path + ": only netCDF files have variables"};
    if (path.find('"') != std::string::npos || variable.find_first_of(":\"") != std::string::npos)
      return TeError{path + ": a quote in the name of the file, or a quote or colon in the variable's"};
    name = "NETCDF:\"" + path + "\":" + variable;
  }
  auto file = std::make_unique<TeGdalRasterFile>();
  file->m_dataset.reset(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  if (!file->m_dataset && driver == "SRTMHGT")
    return TeError{path + ": no SRTM tile: those are named like N46W122.hgt and have 1201x1201, 1801x3601 or "
                          "3601x3601 samples of 16 bits"};
  if (!file->m_dataset)
    return TeError{path + ": " + errors.first("GDAL's driver " + driver + " does not recognise it")};
  if (file->m_dataset->GetRasterCount() < 1) {
    const std::string names = subdatasets(*file->m_dataset);
    return TeError{path + (names.empty() ? ": holds no raster" : ": name one of its variables: " + names)};
  }
  file->m_info.format = driver;
  if (TeStatus ok = file->describe(band); !ok)
    return TeError{path + ": " + ok.error().message};
  return std::unique_ptr<TeRasterFile>(std::move(file));
}

TeStatus TeGdalRasterFile::describe(int number) {
  m_info.columns = m_dataset->GetRasterXSize();
  m_info.rows = m_dataset->GetRasterYSize();
  m_info.bands = m_dataset->GetRasterCount();
  if (m_info.columns < 1 || m_info.rows < 1)
    return TeError{"a raster without posts"};
  GDALRasterBand& band = *m_dataset->GetRasterBand(number <= m_info.bands ? number : 1);
  if (TeStatus ok = checkBlocks(band); !ok)
    return ok;

  m_info.hasTransform = m_dataset->GetGeoTransform(m_info.transform.data()) == CE_None;
  const char* registration = m_dataset->GetMetadataItem(GDALMD_AREA_OR_POINT);
  m_info.pixelIsPoint = registration && EQUAL(registration, GDALMD_AOP_POINT);

  const GDALDataType type = band.GetRasterDataType();
  if (GDALDataTypeIsComplex(type))
    return TeError{"complex samples are no heights"};
  m_info.signed16 = type == GDT_Int16;
  m_info.unsigned16 = type == GDT_UInt16 || type == GDT_Byte;
  m_info.float32 = type == GDT_Float32;
  int given = 0;
  m_info.noData = band.GetNoDataValue(&given);
  m_info.hasNoData = given != 0;
  m_info.scale = band.GetScale(&given);
  if (!given || !std::isfinite(m_info.scale) || m_info.scale == 0)
    m_info.scale = 1;
  m_info.offset = band.GetOffset(&given);
  if (!given || !std::isfinite(m_info.offset))
    m_info.offset = 0;
  m_info.verticalUnit = band.GetUnitType();
  describeSystem();
  return {};
}

// GDAL decodes whole blocks, and a file may claim blocks of any size.
TeStatus TeGdalRasterFile::checkBlocks(GDALRasterBand& band) const {
  int columns = 0;
  int rows = 0;
  band.GetBlockSize(&columns, &rows);
  const char* interleave = m_dataset->GetMetadataItem("INTERLEAVE", "IMAGE_STRUCTURE");
  const int together = interleave && EQUAL(interleave, "PIXEL") ? m_info.bands : 1;
  const double bytes = double(columns) * rows * together * GDALGetDataTypeSizeBytes(band.GetRasterDataType());
  if (columns < 1 || rows < 1 || bytes > double(kMaxBlockBytes))
    return TeError{"blocks of " + std::to_string(columns) + "x" + std::to_string(rows) + " posts in " +
                   std::to_string(together) + " bands are more than the " +
                   std::to_string(kMaxBlockBytes >> 20) + " MB that are read at a time"};
  return {};
}

void TeGdalRasterFile::describeSystem() {
  const OGRSpatialReference* system = m_dataset->GetSpatialRef();
  if (system && system->IsGeographic()) {
    m_info.horizontal = TeHorizontalKind::Geographic;
    m_info.horizontalUnit = system->GetAngularUnits();
    m_info.semiMajor = system->GetSemiMajor();
    m_info.inverseFlattening = system->GetInvFlattening();
    m_projection = std::make_shared<TeGdalProjection>(*system);
  } else if (system && (system->IsProjected() || system->IsGeocentric())) {
    m_info.horizontal = TeHorizontalKind::Linear;
    m_info.horizontalUnit = system->GetLinearUnits();
    m_projection = std::make_shared<TeGdalProjection>(*system);
  } else if (system && system->IsLocal()) {
    m_info.horizontalUnit = system->GetLinearUnits();
  } else if (namesDegrees(m_dataset->GetMetadata())) {
    m_info.horizontal = TeHorizontalKind::Geographic;
    m_info.horizontalUnit = 0.017453292519943295;
    m_projection = TeGdalProjection::degrees();
  }
}

TeStatus TeGdalRasterFile::read(int band, TeRasterWindow window, double* samples) {
  const TeGdalErrors errors;
  std::string reason = "damaged";
  try {
    const CPLErr result = m_dataset->GetRasterBand(band)->RasterIO(
        GF_Read, window.column, window.row, window.columns, window.rows, samples, window.columns, window.rows,
        GDT_Float64, 0, 0, nullptr);
    if (result == CE_None && !errors.failed())
      return {};
  } catch (const std::exception& e) {
    reason = e.what();
  }
  return TeError{"posts from column " + std::to_string(window.column) + ", row " +
                 std::to_string(window.row) + " cannot be read: " + errors.first(reason)};
}
