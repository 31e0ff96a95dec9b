#include "generators/base/TeText.h"

#include <algorithm>
#include <charconv>
#include <cstdarg>
#include <cstddef>
#include <cstdio>

std::string teQuoted(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string quoted = "\"";
  for (char c : text.substr(0, kLongest))
    quoted += (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) ? '?' : c;
  if (text.size() > kLongest)
    quoted += "...";
  return quoted + '"';
}

namespace {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> beforeLast(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    current[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    beforeLast.swap(last);
    last.swap(current);
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({last[j] + 1, current[j - 1] + 1, change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        current[j] = std::min(current[j], beforeLast[j - 2] + 1);
    }
  }
  return current[b.size()];
}

} // namespace

std::string teNearest(std::string_view given, const std::vector<std::string>& candidates) {
  if (given.empty() || given.size() > 64)
    return {};
  std::string nearest;
  std::size_t least = std::max<std::size_t>(1, given.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(given, candidate);
    // Of two equally near names the one that continues what was typed is likelier.
    const bool begun = candidate.size() > given.size() && given.size() >= 2 &&
                       std::string_view(candidate).substr(0, given.size()) == given;
    const std::size_t rank = begun ? std::min<std::size_t>(distance, 1) : distance;
    if (rank < least) {
      least = rank;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string teKnownNames(std::string_view given, const std::vector<std::string>& candidates) {
  std::string text;
  if (const std::string nearest = teNearest(given, candidates); !nearest.empty())
    text += "; did you mean " + nearest + "?";
  text += " (known: ";
  for (std::size_t i = 0; i < candidates.size(); ++i)
    text += (i ? ", " : "") + candidates[i];
  return text + (candidates.empty() ? "none)" : ")");
}

std::string teNumberText(double number) {
  char buffer[40];
  const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof buffer, number);
  return std::string(buffer, end.ptr);
}

std::string teFormat(const char* format, ...) {
  std::va_list values;
  va_start(values, format);
  std::va_list again;
  va_copy(again, values);
  const int length = std::vsnprintf(nullptr, 0, format, values);
  va_end(values);
  std::string text(std::size_t(std::max(0, length)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  return text;
}

std::string teHexText(std::uint64_t number) {
  return teFormat("%016llx", static_cast<unsigned long long>(number));
}
