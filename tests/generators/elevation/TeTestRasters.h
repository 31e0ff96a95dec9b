#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Small elevation files made byte by byte, so that tests need no data and no GDAL to make them. Samples are
/// given row by row from the north.
struct TeTestRaster {
  int columns = 0;
  int rows = 0;
  std::vector<double> samples;

  /// Samples 100 + 10·row + column.
  static TeTestRaster ramp(int columns, int rows);
  double at(int column, int row) const { return samples[std::size_t(row) * columns + column]; }
};

enum class TeTestSample { Int16, UInt16, Int32, Float32 };

/// What a GeoTIFF says besides its samples.
struct TeTestTiff {
  TeTestSample sample = TeTestSample::Int16;
  double west = 0; ///< of the outer corner of the first pixel, or of the first post where pixels are points
  double north = 0;
  double step = 0;    ///< 0 = no georeference
  int geographic = 0; ///< EPSG code, such as 4326
  int projected = 0;
  bool point = false;
  std::string noData; ///< as text; empty = none
};

std::string teTiff(const TeTestRaster& raster, const TeTestTiff& tiff);
std::string teAsciiGrid(const TeTestRaster& raster, double step, const std::string& noData);
/// Projected in metres, UTM zone 11 north.
std::string teBinaryTerrain(const TeTestRaster& raster, double west, double south, double step);
/// SRTM: 1201×1201 big-endian samples.
std::string teHgt(const TeTestRaster& raster);
std::string tePng16(const TeTestRaster& raster);
/// Heights encoded as 256·R + G + B/256 - 32768.
std::string teTerrarium(const TeTestRaster& raster);
/// Classic netCDF; degrees with units and no coordinate system; `z` has 16 bit samples and the given
/// attributes.
std::string teNetCdf(const TeTestRaster& raster, double west, double north, double step,
                     const std::string& unit, int fillValue, double scale);
/// UTM zone 11, metres; profiles from the south, west first. `claimedColumns` as the header says.
std::string teUsgsDem(const TeTestRaster& raster, double west, double south, double step,
                      std::int64_t claimedColumns);
/// Headerless 16 bit samples.
std::string teRaw(const TeTestRaster& raster, bool bigEndian);
