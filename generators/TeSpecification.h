#pragma once

#include "generators/base/TeResult.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A generator or filter named with its parameters in one line of text; the grammar is TeGeneratorRegistry's.
struct TeSpecification {
  static constexpr std::size_t kLongest = 65536;

  std::string name;
  std::vector<std::pair<std::string, std::string>> parameters; ///< names with values, unquoted

  /// Error: the text's first fault and its column.
  static TeResult<TeSpecification> parse(std::string_view text);
  /// Text that parse() reads back.
  std::string text() const;
};
