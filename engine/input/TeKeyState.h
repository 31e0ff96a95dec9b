#pragma once

#include "engine/input/TeKeyEvent.h"

#include <vector>

/// The keys that are held down.
class TeKeyState {
public:
  /// Takes an event in. False if it says nothing new: the repetition of a key that is down, or a release of
  /// one that is not.
  bool change(const TeKeyEvent& event);
  bool isDown(SoKeyboardEvent::Key key) const;
  bool any() const { return !m_down.empty(); }
  /// As if all were released, which a window does not tell when it loses the keyboard.
  void clear() { m_down.clear(); }
  /// In ascending order.
  const std::vector<SoKeyboardEvent::Key>& down() const { return m_down; }

private:
  std::vector<SoKeyboardEvent::Key> m_down;
};
