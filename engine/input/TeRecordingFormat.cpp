#include "engine/input/TeRecordingFormat.h"

#include "engine/input/TeKeyNames.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace {

bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

std::string keyText(const TeKeyEvent& event) {
  std::string text = (event.down ? "+" : "-") + teKeyName(event.key);
  if (event.shift || event.control || event.alt)
    text += '/';
  if (event.shift)
    text += 's';
  if (event.control)
    text += 'c';
  if (event.alt)
    text += 'a';
  return text;
}

std::optional<TeKeyEvent> parseKey(std::string_view word) {
  if (word.empty() || (word[0] != '+' && word[0] != '-'))
    return std::nullopt;
  const std::size_t slash = word.find('/');
  const std::optional<SoKeyboardEvent::Key> key = teKeyNamed(word.substr(1, slash - 1));
  if (!key)
    return std::nullopt;
  TeKeyEvent event;
  event.key = *key;
  event.down = word[0] == '+';
  if (slash != std::string_view::npos) {
    const std::string_view modifiers = word.substr(slash + 1);
    event.shift = modifiers.find('s') != std::string_view::npos;
    event.control = modifiers.find('c') != std::string_view::npos;
    event.alt = modifiers.find('a') != std::string_view::npos;
  }
  return keyText(event) == word ? std::optional<TeKeyEvent>(event) : std::nullopt;
}

/// The text up to the next space, which is taken away with it.
std::string_view takeWord(std::string_view& rest) {
  const std::size_t space = std::min(rest.find(' '), rest.size());
  const std::string_view word = rest.substr(0, space);
  rest.remove_prefix(std::min(space + 1, rest.size()));
  return word;
}

} // namespace

std::string TeRecordingFormat::settingLine(const std::string& name, const std::string& value) {
  return std::string(kSetting) + name + " " + value;
}

std::string TeRecordingFormat::settingFault(const std::string& name, const std::string& value) {
  if (name.empty() || name.find(' ') != std::string::npos)
    return "a setting's name must be one word, not " + teQuoted(name);
  if (std::any_of(name.begin(), name.end(), isControl) || std::any_of(value.begin(), value.end(), isControl))
    return "setting " + teQuoted(name) + " has a control character";
  return {};
}

std::string TeRecordingFormat::frameLine(const TeRecordedFrame& frame) {
  std::string line = teNumberText(frame.dt);
  if (frame.stateHash)
    line += " #" + teHexText(*frame.stateHash);
  for (const TeKeyEvent& event : frame.keys)
    line += " " + keyText(event);
  return line;
}

TeResult<TeRecordedFrame> TeRecordingFormat::parseFrame(std::string_view line) {
  TeRecordedFrame frame;
  std::string_view rest = line;
  const std::string_view time = takeWord(rest);
  const char* end = time.data() + time.size();
  const std::from_chars_result read = std::from_chars(time.data(), end, frame.dt);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(frame.dt) || frame.dt < 0)
    return TeError{teQuoted(time) + " is not a frame's time in seconds"};
  if (!rest.empty() && rest[0] == '#') {
    frame.stateHash = parseHash(takeWord(rest).substr(1));
    if (!frame.stateHash)
      return TeError{"a state's hash must have 16 hexadecimal digits"};
  }
  while (!rest.empty()) {
    const std::string_view word = takeWord(rest);
    const std::optional<TeKeyEvent> key = parseKey(word);
    if (!key)
      return TeError{teQuoted(word) + " is not a key that went down (+NAME) or up (-NAME)"};
    if (frame.keys.size() == kMaxKeys)
      return TeError{"more than " + std::to_string(kMaxKeys) + " keys"};
    frame.keys.push_back(*key);
  }
  return frame;
}

std::optional<std::uint64_t> TeRecordingFormat::parseHash(std::string_view text) {
  std::uint64_t hash = 0;
  const char* end = text.data() + text.size();
  const std::from_chars_result read = std::from_chars(text.data(), end, hash, 16);
  if (read.ec != std::errc() || read.ptr != end || teHexText(hash) != text)
    return std::nullopt;
  return hash;
}
