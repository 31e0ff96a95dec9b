#pragma once

#include "generators/base/TeResult.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// One named parameter of a generator or filter, bound to the public member that holds it. From this table
/// come the command line, the fields of nodes, help texts and range checks, so that each is stated once.
struct TeParameter {
  std::string name;
  std::variant<double*, int*, std::uint64_t*, bool*, std::string*> value;
  double minimum = 0; ///< of double and int, inclusive; a std::uint64_t may have any of its values
  double maximum = 0;
  std::vector<std::string> choices; ///< of texts; empty = any text
  std::string help;                 ///< one line, with the unit
};

using TeParameters = std::vector<TeParameter>;

/// Parses and stores a value. The whole text must be the value: numbers as in C++ ("-2.5e3", no blanks, no
/// '+'), truth values as true/false, on/off, yes/no or 1/0. The error names the parameter, its range and what
/// was given; nothing is stored then. `owner` is the name of the generator or filter, for messages.
TeStatus teSetParameter(const TeParameters& parameters, std::string_view owner, std::string_view name,
                        std::string_view text);
/// Checks that every number is finite and within its range and every text among its choices.
TeStatus teCheckParameters(const TeParameters& parameters, std::string_view owner);
/// The current value as text that teSetParameter reads back to the same bits.
std::string teParameterText(const TeParameter& parameter);
/// What values the parameter may have: "0 to 1", "smooth|step", "true|false", "text".
std::string teParameterRange(const TeParameter& parameter);
/// Hash over names and values, for fingerprints.
std::uint64_t teHashParameters(const TeParameters& parameters, std::uint64_t seed);
