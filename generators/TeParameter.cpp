#include "generators/TeParameter.h"

#include "generators/base/TeHash.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace {

template <class Number> std::optional<Number> parseNumber(std::string_view text) {
  Number number{};
  const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size())
    return std::nullopt;
  return number;
}

std::optional<bool> parseTruth(std::string_view text) {
  for (const char* word : {"true", "on", "yes", "1"})
    if (text == word)
      return true;
  for (const char* word : {"false", "off", "no", "0"})
    if (text == word)
      return false;
  return std::nullopt;
}

bool inRange(const TeParameter& parameter, double number) {
  return std::isfinite(number) && number >= parameter.minimum && number <= parameter.maximum;
}

bool isChoice(const TeParameter& parameter, const std::string& text) {
  return parameter.choices.empty() ||
         std::find(parameter.choices.begin(), parameter.choices.end(), text) != parameter.choices.end();
}

TeError wrongValue(const TeParameter& parameter, std::string_view owner, std::string_view given) {
  std::string message = std::string(owner) + ": " + parameter.name + " is " + teQuoted(given);
  if (std::holds_alternative<std::string*>(parameter.value))
    return TeError{message + teKnownNames(given, parameter.choices)};
  return TeError{message + ", must be " + teParameterRange(parameter)};
}

} // namespace

TeStatus teSetParameter(const TeParameters& parameters, std::string_view owner, std::string_view name,
                        std::string_view text) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [name](const TeParameter& p) { return p.name == name; });
  if (found == parameters.end()) {
    std::vector<std::string> names;
    for (const TeParameter& p : parameters)
      names.push_back(p.name);
    return TeError{std::string(owner) + ": unknown parameter " + teQuoted(name) + teKnownNames(name, names)};
  }
  const TeParameter& parameter = *found;
  if (double* const* value = std::get_if<double*>(&parameter.value)) {
    if (const auto number = parseNumber<double>(text); number && inRange(parameter, *number)) {
      **value = *number;
      return {};
    }
  } else if (int* const* value = std::get_if<int*>(&parameter.value)) {
    if (const auto number = parseNumber<int>(text); number && inRange(parameter, *number)) {
      **value = *number;
      return {};
    }
  } else if (std::uint64_t* const* value = std::get_if<std::uint64_t*>(&parameter.value)) {
    if (const auto number = parseNumber<std::uint64_t>(text)) {
      **value = *number;
      return {};
    }
  } else if (bool* const* value = std::get_if<bool*>(&parameter.value)) {
    if (const auto truth = parseTruth(text)) {
      **value = *truth;
      return {};
    }
  } else if (std::string* const* value = std::get_if<std::string*>(&parameter.value)) {
    if (std::string given(text); isChoice(parameter, given)) {
      **value = std::move(given);
      return {};
    }
  }
  return wrongValue(parameter, owner, text);
}

TeStatus teCheckParameters(const TeParameters& parameters, std::string_view owner) {
  for (const TeParameter& parameter : parameters) {
    bool good = true;
    if (double* const* value = std::get_if<double*>(&parameter.value))
      good = inRange(parameter, **value);
    else if (int* const* value = std::get_if<int*>(&parameter.value))
      good = inRange(parameter, **value);
    else if (std::string* const* value = std::get_if<std::string*>(&parameter.value))
      good = isChoice(parameter, **value);
    if (!good)
      return wrongValue(parameter, owner, teParameterText(parameter));
  }
  return {};
}

std::string teParameterText(const TeParameter& parameter) {
  if (double* const* value = std::get_if<double*>(&parameter.value))
    return teNumberText(**value);
  if (int* const* value = std::get_if<int*>(&parameter.value))
    return std::to_string(**value);
  if (std::uint64_t* const* value = std::get_if<std::uint64_t*>(&parameter.value))
    return std::to_string(**value);
  if (bool* const* value = std::get_if<bool*>(&parameter.value))
    return **value ? "true" : "false";
  return *std::get<std::string*>(parameter.value);
}

std::string teParameterRange(const TeParameter& parameter) {
  if (std::holds_alternative<bool*>(parameter.value))
    return "true|false";
  if (std::holds_alternative<std::string*>(parameter.value)) {
    std::string text;
    for (const std::string& choice : parameter.choices)
      text += (text.empty() ? "" : "|") + choice;
    return text.empty() ? "text" : text;
  }
  if (std::holds_alternative<std::uint64_t*>(parameter.value))
    return "a whole number, 0 to 18446744073709551615";
  const char* kind = std::holds_alternative<int*>(parameter.value) ? "a whole number, " : "a number, ";
  return kind + teNumberText(parameter.minimum) + " to " + teNumberText(parameter.maximum);
}

std::uint64_t teHashParameters(const TeParameters& parameters, std::uint64_t seed) {
  std::uint64_t hash = seed;
  for (const TeParameter& parameter : parameters) {
    hash = teHashCombine(hash, teHashText(parameter.name));
    if (double* const* value = std::get_if<double*>(&parameter.value))
      hash = teHashDouble(hash, **value);
    else if (int* const* value = std::get_if<int*>(&parameter.value))
      hash = teHashCombine(hash, std::uint64_t(std::int64_t(**value)));
    else if (std::uint64_t* const* value = std::get_if<std::uint64_t*>(&parameter.value))
      hash = teHashCombine(hash, **value);
    else if (bool* const* value = std::get_if<bool*>(&parameter.value))
      hash = teHashCombine(hash, std::uint64_t(**value));
    else
      hash = teHashCombine(hash, teHashText(*std::get<std::string*>(parameter.value)));
  }
  return hash;
}
