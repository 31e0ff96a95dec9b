#include "generators/elevation/TeElevationGenerator.h"

#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeText.h"
#include "generators/elevation/TeElevationScan.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace {

/// Numbers separated by commas or blanks.
TeResult<std::vector<double>> parseNumbers(const std::string& what, std::string_view text) {
  std::vector<double> numbers;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(", "), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty())
      continue;
    double number = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), number);
    if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size())
      return TeError{"elevation: " + what + ": " + teQuoted(word) + " is not a number"};
    numbers.push_back(number);
  }
  return numbers;
}

TeStatus parseSize(std::string_view text, int& columns, int& rows) {
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, columns);
  if (first.ec == std::errc() && first.ptr != end && (*first.ptr == 'x' || *first.ptr == 'X')) {
    const auto second = std::from_chars(first.ptr + 1, end, rows);
    if (second.ec == std::errc() && second.ptr == end && columns > 0 && rows > 0)
      return {};
  }
  return TeError{"elevation: raw-size " + teQuoted(text) + ": must be COLUMNSxROWS, each at least 1"};
}

} // namespace

void TeElevationGenerator::setDefaults() {
  file.clear();
  encoding = "auto";
  rawSize.clear();
  rawOrder = "little";
  rawSamples = "signed";
  band = 1;
  variable.clear();
  verticalUnit = "auto";
  horizontalUnit = "auto";
  posts = 0;
  noData.clear();
  fill = "none";
  fillDistance = 100;
  outside = "hole";
  outsideHeight = 0;
  outsideGenerator.clear();
  origin = "centre";
  native = false;
}

TeParameters TeElevationGenerator::parameters() {
  return {
      {"file",
       &file,
       0,
       0,
       {},
       "elevation file: GeoTIFF, SRTM HGT, PNG, Arc ASCII, BT, USGS DEM, netCDF, raw"},
      {"encoding", &encoding, 0, 0, {"auto", "terrarium", "raw"}, "how samples mean heights"},
      {"raw-size", &rawSize, 0, 0, {}, "COLUMNSxROWS of headerless 16 bit data"},
      {"raw-order", &rawOrder, 0, 0, {"little", "big"}, "byte order of headerless data"},
      {"raw-samples", &rawSamples, 0, 0, {"signed", "unsigned"}, "headerless data"},
      {"band", &band, 1, 10000, {}, "which band holds the heights"},
      {"variable", &variable, 0, 0, {}, "which variable of a netCDF file"},
      {"vertical-unit",
       &verticalUnit,
       0,
       0,
       {},
       "of stored heights: auto, m, dm, cm, ft, us-ft or metres, as 0.1"},
      {"horizontal-unit",
       &horizontalUnit,
       0,
       0,
       {"auto", "metres", "feet", "us-feet", "degrees"},
       "of the file's coordinates"},
      {"posts",
       &posts,
       0,
       1e7,
       {},
       "metres between posts instead of the file's georeference; 0 = the file's"},
      {"no-data", &noData, 0, 0, {}, "stored values that mean no data, besides those the file declares"},
      {"fill", &fill, 0, 0, {"none", "voids"}, "missing posts: keep as holes, or fill from around"},
      {"fill-distance",
       &fillDistance,
       1,
       double(TeElevationOptions::kMaxFillDistance),
       {},
       "how many posts away a void is filled from"},
      {"outside", &outside, 0, 0, {"hole", "clamp", "constant", "generator"}, "what stands outside the file"},
      {"outside-height", &outsideHeight, -100000, 100000, {}, "metres, for outside=constant"},
      {"outside-generator", &outsideGenerator, 0, 0, {}, "generator, for outside=generator"},
      {"origin",
       &origin,
       0,
       0,
       {},
       "what lies at the world's origin: centre, south-west or LONGITUDE,LATITUDE"},
      {"native", &native, 0, 0, {}, "samples on the file's own posts, its highest at the world's origin"},
  };
}

TeResult<TeElevationOptions> TeElevationGenerator::options() const {
  TeElevationOptions options;
  if (encoding == "terrarium")
    options.encoding = TeElevationEncoding::Terrarium;
  if (encoding == "raw") {
    options.encoding = TeElevationEncoding::Raw;
    if (TeStatus ok = parseSize(rawSize, options.rawColumns, options.rawRows); !ok)
      return ok.error();
    options.rawBigEndian = rawOrder == "big";
    options.rawSigned = rawSamples == "signed";
  }
  options.band = band;
  options.variable = variable;
  const TeResult<double> unit = teVerticalUnit(verticalUnit);
  if (!unit)
    return TeError{"elevation: vertical-unit: " + unit.error().message};
  options.verticalUnit = *unit;
  options.horizontalUnit = horizontalUnit == "metres"    ? TeHorizontalUnit::Metres
                           : horizontalUnit == "feet"    ? TeHorizontalUnit::Feet
                           : horizontalUnit == "us-feet" ? TeHorizontalUnit::UsFeet
                           : horizontalUnit == "degrees" ? TeHorizontalUnit::Degrees
                                                         : TeHorizontalUnit::Automatic;
  options.posts = posts;
  TeResult<std::vector<double>> numbers = parseNumbers("no-data", noData);
  if (!numbers)
    return numbers.error();
  options.noData = std::move(*numbers);
  options.fillDistance = fill == "voids" ? fillDistance : 0;
  return options;
}

TeStatus TeElevationGenerator::reopen() const {
  if (file.empty())
    return TeError{"elevation: no file is given"};
  const TeResult<TeElevationOptions> wanted = options();
  if (!wanted)
    return wanted.error();
  const TeResult<TeFileStamp> stamp = teFileStamp(file);
  if (!stamp)
    return stamp.error();
  if (m_file && m_file->path() == file && m_stamp == *stamp && m_optionsHash == wanted->hash())
    return {};
  TeResult<TeElevationFilePtr> opened = TeElevationFile::open(file, *wanted);
  if (!opened)
    return opened.error();
  m_file = std::move(*opened);
  m_stamp = *stamp;
  m_optionsHash = wanted->hash();
  m_highest = {-1, -1};
  return {};
}

TeResult<TeElevationPlacement> TeElevationGenerator::placement(const TeElevationFilePtr& opened) const {
  TeElevationPlacement placement;
  placement.outsideHeight = float(outsideHeight);
  if (outside == "clamp")
    placement.outside = TeElevationOutside::Clamp;
  if (outside == "constant")
    placement.outside = TeElevationOutside::Constant;
  if (outside == "generator") {
    placement.outside = TeElevationOutside::Generator;
    const TeResult<TeHeightSourcePtr> source = TeGeneratorRegistry::instance().source(outsideGenerator);
    if (!source)
      return TeError{"elevation: outside-generator: " + source.error().message};
    placement.outsideSource = *source;
  }
  if (origin == "south-west") {
    placement.origin = {opened->extent().west, opened->extent().south};
  } else if (origin != "centre") {
    const TeResult<std::vector<double>> numbers = parseNumbers("origin", origin);
    if (!numbers || numbers->size() != 2)
      return TeError{"elevation: origin " + teQuoted(origin) +
                     ": must be centre, south-west or LONGITUDE,LATITUDE"};
    const TeResult<TePlanePoint> local = opened->fromGeographic({(*numbers)[0], (*numbers)[1]});
    if (!local)
      return local.error();
    placement.origin = *local;
  }
  if (!native)
    return placement;
  if (const TeResult<double> spacing = opened->nativeSpacing(); !spacing)
    return spacing.error();
  if (m_highest.first < 0) {
    const TeResult<TeElevationSummary> summary = TeElevationScan::summarise(opened);
    if (!summary)
      return summary.error();
    m_highest = {summary->highestColumn, summary->highestRow};
  }
  placement.native = true;
  placement.nativeColumn = m_highest.first;
  placement.nativeRow = m_highest.second;
  return placement;
}

TeResult<TeHeightSourcePtr> TeElevationGenerator::makeSource() const {
  if (TeStatus ok = reopen(); !ok)
    return ok.error();
  const TeResult<TeElevationPlacement> placed = placement(m_file);
  if (!placed)
    return placed.error();
  TeResult<std::shared_ptr<const TeElevationSource>> source = TeElevationSource::create(m_file, *placed);
  if (!source)
    return source.error();
  return TeHeightSourcePtr(std::move(*source));
}
