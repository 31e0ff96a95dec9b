#pragma once

#include <Inventor/events/SoKeyboardEvent.h>

#include <optional>
#include <string>
#include <string_view>

/// "A", "7", "F12", "UP_ARROW", "PAD_8", "SPACE": as in SoKeyboardEvent, digits without NUMBER_. A key that
/// has no name there is its number, "0x1a2b".
std::string teKeyName(SoKeyboardEvent::Key key);
/// The key of a name that teKeyName() gives; none for other text.
std::optional<SoKeyboardEvent::Key> teKeyNamed(std::string_view name);
