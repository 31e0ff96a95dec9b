#pragma once

#include <Inventor/events/SoKeyboardEvent.h>

/// A key that went down or up: what objects handle, recordings hold and replays send. Repetitions of a key
/// that is held are left out.
struct TeKeyEvent {
  SoKeyboardEvent::Key key = SoKeyboardEvent::ANY;
  bool down = false;
  bool shift = false;
  bool control = false;
  bool alt = false;

  static TeKeyEvent of(const SoKeyboardEvent& event);

  friend bool operator==(const TeKeyEvent& a, const TeKeyEvent& b) {
    return a.key == b.key && a.down == b.down && a.shift == b.shift && a.control == b.control &&
           a.alt == b.alt;
  }
};
