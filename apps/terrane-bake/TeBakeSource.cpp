#include "apps/terrane-bake/TeBakeSource.h"

#include "apps/common/TeTerrainDescription.h"
#include "apps/terrane-bake/TeRasterRows.h"
#include "apps/terrane-bake/TeResampledRows.h"
#include "generators/base/TeHash.h"
#include "generators/base/TeLog.h"
#include "generators/base/TeText.h"
#include "generators/elevation/TeElevationFile.h"
#include "generators/elevation/TeRasterOpen.h"
#include "nodes/clipmap/TePyramidFiles.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kSameSpacing = 0.01; ///< how much the two directions may differ without a word

std::string sizeText(int columns, int rows) { return std::to_string(columns) + "x" + std::to_string(rows); }

/// How a headerless file is read: a square of the size that its bytes make.
TeStatus describeRaw(const TeMipmapsOptions& options, TeElevationOptions& reading) {
  const TeResult<TeFileStamp> stamp = teFileStamp(options.input);
  if (!stamp)
    return stamp.error();
  const auto side = std::uint64_t(std::sqrt(double(stamp->bytes / 2)) + 0.5);
  if (side < 2 || 2 * side * side != stamp->bytes)
    return TeError{options.input + ": " + std::to_string(stamp->bytes) +
                   " bytes are no square of samples of 16 bits"};
  if (side > std::uint64_t(tePyramidSide(kTeHighestPyramidLevel)))
    return TeError{options.input + ": " + std::to_string(side) + " samples a side; a pyramid has at most " +
                   std::to_string(tePyramidSide(kTeHighestPyramidLevel))};
  reading.encoding = TeElevationEncoding::Raw;
  reading.rawColumns = reading.rawRows = int(side);
  reading.rawBigEndian = options.rawOrder == "big";
  reading.rawSigned = options.rawSamples == "signed";
  return {};
}

} // namespace

TeResult<TeBakeSource> TeBakeSource::open(const TeMipmapsOptions& options) {
  TeElevationOptions reading;
  reading.posts = options.posts;
  reading.noData = options.noData;
  reading.band = std::max(options.band, 1);
  const TeResult<double> unit = teVerticalUnit(options.verticalUnit);
  if (!unit)
    return TeError{"--vertical-unit: " + unit.error().message};
  reading.verticalUnit = *unit;
  TeBakeSource source;
  source.m_path = options.input;
  source.m_fill = options.fill;
  if (options.isRaw()) {
    if (TeStatus ok = describeRaw(options, reading); !ok)
      return ok.error();
    TeTerrainDescription described;
    if (TeStatus ok = described.readIfThere(TeTerrainDescription::besideRaw(options.input)); !ok)
      return ok.error();
    if (reading.posts == 0)
      reading.posts = described.spacing;
    if (reading.verticalUnit == 0)
      reading.verticalUnit = described.heightUnit;
    source.m_offset = described.heightOffset;
  }
  if (TeStatus ok = source.openRows(options, reading); !ok)
    return ok.error();
  if (TeStatus ok = source.fit(options); !ok)
    return ok.error();
  source.m_numbers.resize(std::size_t(source.m_rows->columns()) * std::size_t(source.m_rows->channels()));
  return source;
}

TeStatus TeBakeSource::openRows(const TeMipmapsOptions& options, const TeElevationOptions& reading) {
  // What the file says of its place and unit, and its fingerprint; the samples are read as they are stored.
  const TeResult<TeElevationFilePtr> file = TeElevationFile::open(m_path, reading);
  if (!file)
    return file.error();
  TeResult<std::unique_ptr<TeRasterFile>> raster = teOpenRaster(m_path, reading);
  if (!raster)
    return raster.error();
  const TeRasterInfo info = (*raster)->info();
  m_fingerprint = teHashCombine((*file)->fingerprint(), options.hash());
  const TePlanePoint posts = (*file)->postSpacing();
  m_spacing = std::sqrt(posts.x * posts.y);
  if (std::fabs(posts.x - posts.y) > kSameSpacing * m_spacing)
    TeLog::warning(m_path + ": its posts lie " + teNumberText(posts.x) + " m apart to the east and " +
                   teNumberText(posts.y) + " m to the north; the terrain is a square of " +
                   teNumberText(m_spacing) + " m");
  m_unit = info.scale * (*file)->verticalUnit();
  m_offset += info.offset * (*file)->verticalUnit();

  const bool colour = options.band == 0 && (info.bands == 3 || info.bands == 4);
  const TePostDecoder decoder(info, reading, (*file)->verticalUnit());
  m_codeIsKnown = colour || (info.unsigned16 && !info.hasNoData && options.noData.empty() && !m_fill);
  m_rows = std::make_unique<TeRasterRows>(m_path, std::move(*raster), reading.band, colour ? info.bands : 1,
                                          decoder, m_fill);
  m_stored = m_rows.get();
  m_channels = m_rows->channels();
  return {};
}

TeStatus TeBakeSource::fit(const TeMipmapsOptions& options) {
  const int columns = m_rows->columns();
  const int rows = m_rows->rows();
  m_level = columns == rows ? tePyramidLevelOfSide(columns) : -1;
  if (m_level > 0)
    return {};
  if (!options.resample)
    return TeError{m_path + ": " + sizeText(columns, rows) +
                   " samples; a pyramid needs a square of 2^n + 1 (3 to 65537); --resample makes one"};
  const int longest = std::max(columns, rows);
  if (std::min(columns, rows) < 2 || longest > tePyramidSide(kTeHighestPyramidLevel))
    return TeError{m_path + ": " + sizeText(columns, rows) +
                   " samples; a pyramid can be made of 2 to 65537 a side"};
  if (columns != rows && !m_fill)
    return TeError{m_path + ": " + sizeText(columns, rows) +
                   " samples are no square; --fill gives the ground beside them a value"};
  for (m_level = 1; tePyramidSide(m_level) < longest;)
    ++m_level;
  auto resampled = std::make_unique<TeResampledRows>(std::move(m_rows), tePyramidSide(m_level), m_fill);
  m_spacing *= resampled->step();
  m_rows = std::move(resampled);
  return {};
}

TeStatus TeBakeSource::measure(const std::function<void(double)>& progress) {
  if (m_codeIsKnown)
    return {};
  const TeResult<TeHeightCode> code = TeHeightCode::measured(m_path, *m_stored, m_fill, progress);
  if (!code)
    return code.error();
  m_code = *code;
  return {};
}

TeStatus TeBakeSource::read(int row, unsigned char* samples) {
  if (TeStatus ok = m_rows->read(row, m_numbers.data()); !ok)
    return ok;
  if (isColour()) {
    for (double number : m_numbers)
      *samples++ = static_cast<unsigned char>(std::clamp(std::floor(number + 0.5), 0.0, 255.0));
    return {};
  }
  for (double number : m_numbers) {
    if (std::isnan(number))
      return TeError{m_path + ": samples without data in row " + std::to_string(row)};
    const std::uint16_t code = m_code.of(number);
    *samples++ = static_cast<unsigned char>(code & 0xff);
    *samples++ = static_cast<unsigned char>(code >> 8);
  }
  return {};
}

void TeBakeSource::close() {
  m_rows.reset();
  m_stored = nullptr;
}
