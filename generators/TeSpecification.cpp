#include "generators/TeSpecification.h"

#include "generators/base/TeText.h"

#include <algorithm>

namespace {

TeError wrong(std::string_view text, std::size_t at, const std::string& what) {
  return TeError{"specification " + teQuoted(text) + ", column " + std::to_string(at + 1) + ": " + what};
}

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         c == '.';
}

std::string readName(std::string_view text, std::size_t& at) {
  const std::size_t begin = at;
  while (at < text.size() && isNameCharacter(text[at]))
    ++at;
  return std::string(text.substr(begin, at - begin));
}

/// A value from its opening quote to behind its closing one.
TeResult<std::string> readQuoted(std::string_view text, std::size_t& at) {
  const std::size_t begin = at++;
  std::string value;
  for (; at < text.size(); ++at) {
    if (text[at] != '"') {
      value += text[at];
      continue;
    }
    const bool doubled = at + 1 < text.size() && text[at + 1] == '"';
    if (!doubled) {
      ++at;
      return value;
    }
    value += '"';
    ++at;
  }
  return wrong(text, begin, "the quote is not closed");
}

TeResult<std::string> readValue(std::string_view text, std::size_t& at) {
  if (at < text.size() && text[at] == '"')
    return readQuoted(text, at);
  std::string value;
  for (; at < text.size() && text[at] != ','; ++at) {
    if (text[at] == '"' || text[at] == ' ' || text[at] == '\t')
      return wrong(text, at, "a value with a blank or a quote in it must stand in double quotes");
    value += text[at];
  }
  return value;
}

} // namespace

TeResult<TeSpecification> TeSpecification::parse(std::string_view text) {
  if (text.size() > kLongest)
    return wrong(text, kLongest, "longer than " + std::to_string(kLongest) + " characters");
  std::size_t at = 0;
  TeSpecification result;
  result.name = readName(text, at);
  if (result.name.empty())
    return wrong(text, at, "a name is missing; expected name or name:parameter=value,...");
  if (at == text.size())
    return result;
  if (text[at] != ':')
    return wrong(text, at, "expected ':' or the end after the name");
  do {
    ++at; // the ':' or ','
    const std::size_t begin = at;
    std::string name = readName(text, at);
    if (name.empty() || at == text.size() || text[at] != '=')
      return wrong(text, at, "expected parameter=value");
    const auto same = [&name](const auto& parameter) { return parameter.first == name; };
    if (std::any_of(result.parameters.begin(), result.parameters.end(), same))
      return wrong(text, begin, "parameter " + name + " is given twice");
    ++at;
    TeResult<std::string> value = readValue(text, at);
    if (!value)
      return value.error();
    if (at < text.size() && text[at] != ',')
      return wrong(text, at, "expected ',' or the end after the quoted value");
    result.parameters.emplace_back(std::move(name), std::move(*value));
  } while (at < text.size());
  return result;
}

std::string TeSpecification::text() const {
  std::string text = name;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto& [parameter, value] = parameters[i];
    text += (i ? "," : ":") + parameter + "=";
    if (value.find_first_of(", \t\"") == std::string::npos) {
      text += value;
      continue;
    }
    text += '"';
    for (char c : value)
      text += c == '"' ? std::string("\"\"") : std::string(1, c);
    text += '"';
  }
  return text;
}
