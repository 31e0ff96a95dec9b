#include "generators/elevation/TeTestRasters.h"

#include <cstdio>
#include <cstring>

namespace {

void little(std::string& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i)
    bytes += char(value >> (8 * i) & 255);
}

void big(std::string& bytes, std::uint64_t value, int count) {
  for (int i = count - 1; i >= 0; --i)
    bytes += char(value >> (8 * i) & 255);
}

template <class Number> std::uint64_t bitsOf(Number number) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof number);
  return bits;
}

std::string printed(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// A text in a field of fixed width, at its right end.
std::string field(std::int64_t value, int width) {
  const std::string text = std::to_string(value);
  return std::string(std::size_t(width) - std::min(text.size(), std::size_t(width)), ' ') + text;
}

/// A number in FORTRAN's D24.15.
std::string dField(double value) {
  std::string text = printed("%24.15E", value);
  for (char& c : text)
    if (c == 'E')
      c = 'D';
  return text;
}

std::uint32_t crc(const std::string& bytes) {
  std::uint32_t sum = 0xFFFFFFFFu;
  for (unsigned char c : bytes) {
    sum ^= c;
    for (int i = 0; i < 8; ++i)
      sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320u : 0);
  }
  return ~sum;
}

void pngChunk(std::string& png, const std::string& type, const std::string& data) {
  big(png, data.size(), 4);
  png += type + data;
  big(png, crc(type + data), 4);
}

/// A PNG whose scan lines are stored without compression.
std::string png(int columns, int rows, int depth, int colour, const std::string& lines) {
  std::string header;
  big(header, std::uint64_t(columns), 4);
  big(header, std::uint64_t(rows), 4);
  header += {char(depth), char(colour), 0, 0, 0};
  std::string stored = "\x78\x01";
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (unsigned char c : lines) {
    a = (a + c) % 65521;
    b = (b + a) % 65521;
  }
  for (std::size_t at = 0; at < lines.size(); at += 65535) {
    const std::string block = lines.substr(at, 65535);
    stored += char(at + 65535 >= lines.size());
    little(stored, block.size(), 2);
    little(stored, ~block.size(), 2);
    stored += block;
  }
  big(stored, b << 16 | a, 4);
  std::string bytes = "\x89PNG\r\n\x1a\n";
  pngChunk(bytes, "IHDR", header);
  pngChunk(bytes, "IDAT", stored);
  pngChunk(bytes, "IEND", "");
  return bytes;
}

struct TiffEntry {
  int tag;
  int type; ///< 2 text, 3 short, 4 long, 12 double
  std::uint32_t count;
  std::string data;
};

TiffEntry numbers(int tag, int type, const std::vector<double>& values) {
  TiffEntry entry{tag, type, std::uint32_t(values.size()), {}};
  for (double value : values)
    type == 12 ? little(entry.data, bitsOf(value), 8)
               : little(entry.data, std::uint64_t(value), type == 3 ? 2 : 4);
  return entry;
}

void tiffSample(std::string& bytes, double sample, TeTestSample type) {
  if (type == TeTestSample::Float32)
    little(bytes, bitsOf(float(sample)), 4);
  else
    little(bytes, std::uint64_t(std::int64_t(sample)), type == TeTestSample::Int32 ? 4 : 2);
}

std::string cdfName(const std::string& name) {
  std::string bytes;
  big(bytes, name.size(), 4);
  bytes += name;
  bytes.resize((bytes.size() + 3) / 4 * 4);
  return bytes;
}

std::string cdfAttribute(const std::string& name, int type, std::uint32_t count, std::string values) {
  std::string bytes = cdfName(name);
  big(bytes, std::uint64_t(type), 4);
  big(bytes, count, 4);
  values.resize((values.size() + 3) / 4 * 4);
  return bytes + values;
}

} // namespace

TeTestRaster TeTestRaster::ramp(int columns, int rows) {
  TeTestRaster raster{columns, rows, {}};
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      raster.samples.push_back(100 + 10 * r + c);
  return raster;
}

std::string teTiff(const TeTestRaster& raster, const TeTestTiff& tiff) {
  const int bits = tiff.sample == TeTestSample::Int16 || tiff.sample == TeTestSample::UInt16 ? 16 : 32;
  const int format = tiff.sample == TeTestSample::Float32 ? 3 : tiff.sample == TeTestSample::UInt16 ? 1 : 2;
  constexpr int kRowsPerStrip = 4;
  std::string data;
  std::vector<double> offsets;
  std::vector<double> counts;
  for (int r = 0; r < raster.rows; ++r) {
    if (r % kRowsPerStrip == 0) {
      offsets.push_back(8 + double(data.size()));
      counts.push_back(0);
    }
    for (int c = 0; c < raster.columns; ++c)
      tiffSample(data, raster.at(c, r), tiff.sample);
    counts.back() += double(raster.columns) * bits / 8;
  }
  if (data.size() % 2)
    data += '\0';

  std::vector<TiffEntry> entries = {numbers(256, 4, {double(raster.columns)}),
                                    numbers(257, 4, {double(raster.rows)}),
                                    numbers(258, 3, {double(bits)}),
                                    numbers(259, 3, {1}),
                                    numbers(262, 3, {1}),
                                    numbers(273, 4, offsets),
                                    numbers(277, 3, {1}),
                                    numbers(278, 4, {kRowsPerStrip}),
                                    numbers(279, 4, counts),
                                    numbers(339, 3, {double(format)})};
  if (tiff.step > 0) {
    entries.push_back(numbers(33550, 12, {tiff.step, tiff.step, 0}));
    entries.push_back(numbers(33922, 12, {0, 0, 0, tiff.west, tiff.north, 0}));
    std::vector<double> keys = {1, 1, 0, 1, 1025, 0, 1, tiff.point ? 2.0 : 1.0};
    if (const int code = tiff.projected ? tiff.projected : tiff.geographic) {
      keys[3] = 3;
      keys.insert(keys.begin() + 4, {1024, 0, 1, tiff.projected ? 1.0 : 2.0});
      keys.insert(keys.end(), {tiff.projected ? 3072.0 : 2048.0, 0, 1, double(code)});
    }
    entries.push_back(numbers(34735, 3, keys));
  }
  if (!tiff.noData.empty())
    entries.push_back({42113, 2, std::uint32_t(tiff.noData.size() + 1), tiff.noData + '\0'});

  std::string directory;
  std::string values;
  const std::size_t directoryAt = 8 + data.size();
  const std::size_t valuesAt = directoryAt + 2 + 12 * entries.size() + 4;
  little(directory, entries.size(), 2);
  for (const TiffEntry& entry : entries) {
    little(directory, std::uint64_t(entry.tag), 2);
    little(directory, std::uint64_t(entry.type), 2);
    little(directory, entry.count, 4);
    std::string inPlace = entry.data;
    if (inPlace.size() > 4) {
      inPlace.clear();
      little(inPlace, valuesAt + values.size(), 4);
      values += entry.data;
      if (values.size() % 2)
        values += '\0';
    }
    inPlace.resize(4);
    directory += inPlace;
  }
  little(directory, 0, 4);
  std::string bytes("II*\0", 4);
  little(bytes, directoryAt, 4);
  return bytes + data + directory + values;
}

std::string teAsciiGrid(const TeTestRaster& raster, double step, const std::string& noData) {
  std::string text = "ncols " + std::to_string(raster.columns) + "\nnrows " + std::to_string(raster.rows) +
                     "\nxllcorner 1000\nyllcorner 2000\ncellsize " + printed("%.10g", step) + "\n";
  if (!noData.empty())
    text += "NODATA_value " + noData + "\n";
  for (int r = 0; r < raster.rows; ++r)
    for (int c = 0; c < raster.columns; ++c)
      text += printed("%.9g", raster.at(c, r)) + (c + 1 < raster.columns ? " " : "\n");
  return text;
}

std::string teBinaryTerrain(const TeTestRaster& raster, double west, double south, double step) {
  std::string bytes = "binterr1.3";
  little(bytes, std::uint64_t(raster.columns), 4);
  little(bytes, std::uint64_t(raster.rows), 4);
  little(bytes, 2, 2);  // bytes a sample
  little(bytes, 0, 2);  // whole numbers
  little(bytes, 1, 2);  // metres
  little(bytes, 11, 2); // UTM zone
  little(bytes, 6326, 2);
  for (double edge : {west, west + step * raster.columns, south, south + step * raster.rows})
    little(bytes, bitsOf(edge), 8);
  little(bytes, 0, 2); // no file of the coordinate system
  little(bytes, bitsOf(1.0f), 4);
  bytes.resize(256);
  for (int c = 0; c < raster.columns; ++c)
    for (int r = raster.rows - 1; r >= 0; --r)
      little(bytes, std::uint64_t(std::int64_t(raster.at(c, r))), 2);
  return bytes;
}

std::string teRaw(const TeTestRaster& raster, bool bigEndian) {
  std::string bytes;
  for (double sample : raster.samples)
    bigEndian ? big(bytes, std::uint64_t(std::int64_t(sample)), 2)
              : little(bytes, std::uint64_t(std::int64_t(sample)), 2);
  return bytes;
}

std::string teHgt(const TeTestRaster& raster) { return teRaw(raster, true); }

std::string tePng16(const TeTestRaster& raster) {
  std::string lines;
  for (int r = 0; r < raster.rows; ++r) {
    lines += '\0';
    for (int c = 0; c < raster.columns; ++c)
      big(lines, std::uint64_t(raster.at(c, r)), 2);
  }
  return png(raster.columns, raster.rows, 16, 0, lines);
}

std::string teTerrarium(const TeTestRaster& raster) {
  std::string lines;
  for (int r = 0; r < raster.rows; ++r) {
    lines += '\0';
    for (int c = 0; c < raster.columns; ++c)
      big(lines, std::uint64_t((raster.at(c, r) + 32768) * 256), 3);
  }
  return png(raster.columns, raster.rows, 8, 2, lines);
}

std::string teNetCdf(const TeTestRaster& raster, double west, double north, double step,
                     const std::string& unit, int fillValue, double scale) {
  std::string fill;
  big(fill, std::uint64_t(std::int64_t(fillValue)), 2);
  std::string factor;
  big(factor, bitsOf(scale), 8);
  struct Variable {
    std::string name;
    std::vector<int> dimensions;
    std::string attributes;
    std::uint32_t attributeCount;
    int type; ///< 3 short, 6 double
    std::string data;
  };
  std::vector<Variable> variables = {{"lat", {0}, cdfAttribute("units", 2, 13, "degrees_north"), 1, 6, {}},
                                     {"lon", {1}, cdfAttribute("units", 2, 12, "degrees_east"), 1, 6, {}},
                                     {"z",
                                      {0, 1},
                                      cdfAttribute("units", 2, std::uint32_t(unit.size()), unit) +
                                          cdfAttribute("_FillValue", 3, 1, fill) +
                                          cdfAttribute("scale_factor", 6, 1, factor),
                                      3,
                                      3,
                                      {}}};
  for (int r = 0; r < raster.rows; ++r)
    big(variables[0].data, bitsOf(north - step * r), 8);
  for (int c = 0; c < raster.columns; ++c)
    big(variables[1].data, bitsOf(west + step * c), 8);
  variables[2].data = teRaw(raster, true);
  variables[2].data.resize((variables[2].data.size() + 3) / 4 * 4);

  std::string bytes;
  for (std::uint64_t at = 0, pass = 0; pass < 2; ++pass, at = bytes.size()) {
    bytes.assign("CDF\1", 4);
    big(bytes, 0, 4);
    big(bytes, 10, 4);
    big(bytes, 2, 4);
    bytes += cdfName("lat");
    big(bytes, std::uint64_t(raster.rows), 4);
    bytes += cdfName("lon");
    big(bytes, std::uint64_t(raster.columns), 4);
    big(bytes, 0, 8);
    big(bytes, 11, 4);
    big(bytes, variables.size(), 4);
    for (const Variable& variable : variables) {
      bytes += cdfName(variable.name);
      big(bytes, variable.dimensions.size(), 4);
      for (int dimension : variable.dimensions)
        big(bytes, std::uint64_t(dimension), 4);
      big(bytes, 12, 4);
      big(bytes, variable.attributeCount, 4);
      bytes += variable.attributes;
      big(bytes, std::uint64_t(variable.type), 4);
      big(bytes, variable.data.size(), 4);
      big(bytes, at, 4);
      at += variable.data.size();
    }
  }
  for (const Variable& variable : variables)
    bytes += variable.data;
  return bytes;
}

std::string teUsgsDem(const TeTestRaster& raster, double west, double south, double step,
                      std::int64_t claimedColumns) {
  const double east = west + step * (raster.columns - 1);
  const double north = south + step * (raster.rows - 1);
  std::string text = "A small DEM made for a test";
  text.resize(144, ' ');
  for (int value : {1, 1, 1, 11}) // level, regular pattern, UTM, its zone
    text += field(value, 6);
  for (int i = 0; i < 15; ++i)
    text += dField(0);
  for (int value : {2, 2, 4}) // metres, metres, sides of the polygon
    text += field(value, 6);
  for (double corner : {west, south, west, north, east, north, east, south})
    text += dField(corner);
  text += dField(0) + dField(9999) + dField(0) + field(0, 6);
  text += printed("%12.6E", step) + printed("%12.6E", step) + printed("%12.6E", 1);
  text += field(1, 6) + field(claimedColumns, 6);
  text.resize(1024, ' ');
  for (int c = 0; c < raster.columns; ++c) {
    std::string profile = field(1, 6) + field(c + 1, 6) + field(raster.rows, 6) + field(1, 6);
    profile += dField(west + step * c) + dField(south) + dField(0) + dField(0) + dField(9999);
    for (int r = raster.rows - 1; r >= 0; --r)
      profile += field(std::int64_t(raster.at(c, r)), 6);
    profile.resize(1024, ' ');
    text += profile;
  }
  return text;
}
