#include "engine/input/TeKeyNames.h"

#include <charconv>
#include <cstdio>

namespace {

using Key = SoKeyboardEvent::Key;

struct NamedKey {
  Key key;
  const char* name;
};

/// Besides letters, digits and F1 .. F12. Where SoKeyboardEvent has two names for a key, one of them.
const NamedKey kNamedKeys[] = {
    {Key::ANY, "ANY"},
    {Key::UNDEFINED, "UNDEFINED"},
    {Key::LEFT_SHIFT, "LEFT_SHIFT"},
    {Key::RIGHT_SHIFT, "RIGHT_SHIFT"},
    {Key::LEFT_CONTROL, "LEFT_CONTROL"},
    {Key::RIGHT_CONTROL, "RIGHT_CONTROL"},
    {Key::LEFT_ALT, "LEFT_ALT"},
    {Key::RIGHT_ALT, "RIGHT_ALT"},
    {Key::HOME, "HOME"},
    {Key::LEFT_ARROW, "LEFT_ARROW"},
    {Key::UP_ARROW, "UP_ARROW"},
    {Key::RIGHT_ARROW, "RIGHT_ARROW"},
    {Key::DOWN_ARROW, "DOWN_ARROW"},
    {Key::PAGE_UP, "PAGE_UP"},
    {Key::PAGE_DOWN, "PAGE_DOWN"},
    {Key::END, "END"},
    {Key::PAD_ENTER, "PAD_ENTER"},
    {Key::PAD_F1, "PAD_F1"},
    {Key::PAD_F2, "PAD_F2"},
    {Key::PAD_F3, "PAD_F3"},
    {Key::PAD_F4, "PAD_F4"},
    {Key::PAD_0, "PAD_0"},
    {Key::PAD_1, "PAD_1"},
    {Key::PAD_2, "PAD_2"},
    {Key::PAD_3, "PAD_3"},
    {Key::PAD_4, "PAD_4"},
    {Key::PAD_5, "PAD_5"},
    {Key::PAD_6, "PAD_6"},
    {Key::PAD_7, "PAD_7"},
    {Key::PAD_8, "PAD_8"},
    {Key::PAD_9, "PAD_9"},
    {Key::PAD_ADD, "PAD_ADD"},
    {Key::PAD_SUBTRACT, "PAD_SUBTRACT"},
    {Key::PAD_MULTIPLY, "PAD_MULTIPLY"},
    {Key::PAD_DIVIDE, "PAD_DIVIDE"},
    {Key::PAD_TAB, "PAD_TAB"},
    {Key::PAD_PERIOD, "PAD_PERIOD"},
    {Key::BACKSPACE, "BACKSPACE"},
    {Key::TAB, "TAB"},
    {Key::RETURN, "RETURN"},
    {Key::PAUSE, "PAUSE"},
    {Key::SCROLL_LOCK, "SCROLL_LOCK"},
    {Key::ESCAPE, "ESCAPE"},
    {Key::KEY_DELETE, "DELETE"},
    {Key::PRINT, "PRINT"},
    {Key::INSERT, "INSERT"},
    {Key::NUM_LOCK, "NUM_LOCK"},
    {Key::CAPS_LOCK, "CAPS_LOCK"},
    {Key::SHIFT_LOCK, "SHIFT_LOCK"},
    {Key::SPACE, "SPACE"},
    {Key::APOSTROPHE, "APOSTROPHE"},
    {Key::COMMA, "COMMA"},
    {Key::MINUS, "MINUS"},
    {Key::PERIOD, "PERIOD"},
    {Key::SLASH, "SLASH"},
    {Key::SEMICOLON, "SEMICOLON"},
    {Key::EQUAL, "EQUAL"},
    {Key::BRACKETLEFT, "BRACKETLEFT"},
    {Key::BACKSLASH, "BACKSLASH"},
    {Key::BRACKETRIGHT, "BRACKETRIGHT"},
    {Key::GRAVE, "GRAVE"},
};

constexpr unsigned kLargestKey = 0xFFFF; ///< of SoKeyboardEvent

} // namespace

std::string teKeyName(SoKeyboardEvent::Key key) {
  if (key >= Key::A && key <= Key::Z)
    return std::string(1, char('A' + (key - Key::A)));
  if (key >= Key::NUMBER_0 && key <= Key::NUMBER_9)
    return std::string(1, char('0' + (key - Key::NUMBER_0)));
  if (key >= Key::F1 && key <= Key::F12)
    return "F" + std::to_string(key - Key::F1 + 1);
  for (const NamedKey& named : kNamedKeys)
    if (named.key == key)
      return named.name;
  char number[16];
  std::snprintf(number, sizeof number, "0x%x", unsigned(key));
  return number;
}

std::optional<SoKeyboardEvent::Key> teKeyNamed(std::string_view name) {
  std::optional<Key> key;
  if (name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z')
    key = Key(Key::A + (name[0] - 'A'));
  else if (name.size() == 1 && name[0] >= '0' && name[0] <= '9')
    key = Key(Key::NUMBER_0 + (name[0] - '0'));
  for (const NamedKey& named : kNamedKeys)
    if (!key && name == named.name)
      key = named.key;
  unsigned number = 0;
  const char* end = name.data() + name.size();
  if (!key && name.size() >= 2 && name[0] == 'F' &&
      std::from_chars(name.data() + 1, end, number).ptr == end && number >= 1 && number <= 12)
    key = Key(Key::F1 + (number - 1));
  if (!key && name.size() > 2 && name.substr(0, 2) == "0x" &&
      std::from_chars(name.data() + 2, end, number, 16).ptr == end && number <= kLargestKey)
    key = Key(number);
  // Each key has one name: not "F01" or "0x61".
  return key && teKeyName(*key) == name ? key : std::nullopt;
}
