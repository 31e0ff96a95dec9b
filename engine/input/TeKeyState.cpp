#include "engine/input/TeKeyState.h"

#include <algorithm>

bool TeKeyState::change(const TeKeyEvent& event) {
  const auto place = std::lower_bound(m_down.begin(), m_down.end(), event.key);
  const bool wasDown = place != m_down.end() && *place == event.key;
  if (wasDown == event.down)
    return false;
  if (event.down)
    m_down.insert(place, event.key);
  else
    m_down.erase(place);
  return true;
}

bool TeKeyState::isDown(SoKeyboardEvent::Key key) const {
  return std::binary_search(m_down.begin(), m_down.end(), key);
}
