#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Text that came from a user, fit to stand in a one-line message: in double quotes, control characters as
/// '?', shortened to 60 characters.
std::string teQuoted(std::string_view text);

/// The candidate nearest to a mistyped name by Damerau-Levenshtein distance (optimal string alignment), if it
/// is near enough to be meant; else empty. Cost: product of the lengths, for names up to 64 characters.
std::string teNearest(std::string_view given, const std::vector<std::string>& candidates);

/// "; did you mean X? (known: A, B, C)": what error messages about an unknown name say in the end.
std::string teKnownNames(std::string_view given, const std::vector<std::string>& candidates);

/// As printf.
std::string teFormat(const char* format, ...) __attribute__((format(printf, 1, 2)));

/// 16 hexadecimal digits.
std::string teHexText(std::uint64_t number);

/// The shortest decimal text that reads back to the same bits.
std::string teNumberText(double number);
