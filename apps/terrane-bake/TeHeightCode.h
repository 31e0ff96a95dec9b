#pragma once

#include "apps/terrane-bake/TeRows.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

/// How stored numbers become 16 bits without sign: number = offset + step · code. A code is the stored number
/// itself where all of them are whole and fit.
struct TeHeightCode {
  double step = 1;
  double offset = 0;

  /// Rounded to the nearest code; numbers beyond the first and last become these.
  std::uint16_t of(double number) const;

  /// For these numbers: as they are; or less a whole offset; or, if they are not whole or too far apart,
  /// 65536 even steps from the lowest to the highest.
  static TeHeightCode covering(double lowest, double highest, bool whole);
  /// Looks at all rows; `also` is a number that comes besides. Error: unreadable, or a number is missing; the
  /// message begins with `path`.
  static TeResult<TeHeightCode> measured(const std::string& path, TeRows& rows, std::optional<double> also,
                                         const std::function<void(double)>& progress);
};
