#include "engine/input/TeKeyEvent.h"

TeKeyEvent TeKeyEvent::of(const SoKeyboardEvent& event) {
  return {event.getKey(), event.getState() == SoButtonEvent::DOWN, event.wasShiftDown() != FALSE,
          event.wasCtrlDown() != FALSE, event.wasAltDown() != FALSE};
}
