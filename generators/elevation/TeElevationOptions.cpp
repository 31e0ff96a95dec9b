#include "generators/elevation/TeElevationOptions.h"

#include "generators/base/TeHash.h"
#include "generators/base/TeText.h"

#include <charconv>
#include <cmath>

TeStatus TeElevationOptions::check() const {
  if (encoding == TeElevationEncoding::Raw && (rawColumns < 1 || rawRows < 1))
    return TeError{"raw elevation data needs its size, columns and rows of at least 1"};
  if (band < 1)
    return TeError{"band " + std::to_string(band) + ": bands are numbered from 1"};
  if (!(verticalUnit >= 0) || !std::isfinite(verticalUnit))
    return TeError{"vertical unit: not a positive number of metres"};
  if (!(posts >= 0) || !std::isfinite(posts))
    return TeError{"posts: not a positive number of metres"};
  if (fillDistance < 0 || fillDistance > kMaxFillDistance)
    return TeError{"fill distance " + std::to_string(fillDistance) + ": must be 0 .. " +
                   std::to_string(kMaxFillDistance) + " posts"};
  return {};
}

std::uint64_t TeElevationOptions::hash() const {
  std::uint64_t hash = teHashText(variable);
  for (int value : {int(encoding), rawColumns, rawRows, int(rawBigEndian), int(rawSigned), band,
                    int(horizontalUnit), fillDistance})
    hash = teHashCombine(hash, std::uint64_t(value));
  hash = teHashDouble(teHashDouble(hash, verticalUnit), posts);
  for (double value : noData)
    hash = teHashDouble(hash, value);
  return hash;
}

TeResult<double> teVerticalUnit(const std::string& name) {
  struct Unit {
    const char* name;
    double metres;
  };
  static const Unit units[] = {{"auto", 0},
                               {"m", 1},
                               {"metre", 1},
                               {"metres", 1},
                               {"meter", 1},
                               {"meters", 1},
                               {"dm", 0.1},
                               {"decimetre", 0.1},
                               {"decimetres", 0.1},
                               {"decimeter", 0.1},
                               {"decimeters", 0.1},
                               {"cm", 0.01},
                               {"centimetre", 0.01},
                               {"centimetres", 0.01},
                               {"centimeter", 0.01},
                               {"centimeters", 0.01},
                               {"mm", 0.001},
                               {"km", 1000},
                               {"kilometre", 1000},
                               {"kilometer", 1000},
                               {"ft", 0.3048},
                               {"foot", 0.3048},
                               {"feet", 0.3048},
                               {"us-ft", 1200.0 / 3937},
                               {"us-feet", 1200.0 / 3937},
                               {"us-foot", 1200.0 / 3937},
                               {"sft", 1200.0 / 3937},
                               {"ftus", 1200.0 / 3937},
                               {"us survey foot", 1200.0 / 3937},
                               {"us survey feet", 1200.0 / 3937}};
  std::string lower = name;
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z')
      c = char(c - 'A' + 'a');
  for (const Unit& unit : units)
    if (lower == unit.name)
      return unit.metres;
  double number = 0;
  const auto parsed = std::from_chars(name.data(), name.data() + name.size(), number);
  if (parsed.ec == std::errc() && parsed.ptr == name.data() + name.size() && number > 0 &&
      std::isfinite(number))
    return number;
  return TeError{"unit " + teQuoted(name) +
                 ": must be auto, m, dm, cm, mm, km, ft, us-ft or a positive number of metres"};
}
