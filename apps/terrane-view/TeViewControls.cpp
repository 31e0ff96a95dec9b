#include "apps/terrane-view/TeViewControls.h"

#include <algorithm>

namespace {

using Key = SoKeyboardEvent::Key;

constexpr double kMostPrecision = 64;
constexpr double kFirstPixelError = 4;
constexpr double kLeastPixelError = 0.1, kMostPixelError = 256;

} // namespace

TeViewControls::TeViewControls(const TeViewOptions& options, TeLodNodes& nodes)
    : m_nodes(nodes), m_secondCamera(options.secondCamera), m_statistics(options.statistics) {
  if (options.wireframe)
    setWireframe(true);
}

void TeViewControls::setWireframe(bool on) {
  m_wireframe = on;
  m_nodes.setWireframe(on);
}

bool TeViewControls::handleKey(const TeKeyEvent& event) { return event.down && pressed(event.key); }

bool TeViewControls::pressed(Key key) {
  switch (key) {
  case Key::W:
  case Key::X:
  case Key::F3:
    setWireframe(!m_wireframe);
    return true;
  case Key::C:
  case Key::F2:
    m_secondCamera = !m_secondCamera;
    return true;
  case Key::H:
    m_statistics = !m_statistics;
    return true;
  case Key::F1:
  case Key::SLASH:
    m_help = !m_help;
    return true;
  case Key::P:
  case Key::SPACE:
    m_paused = !m_paused;
    return true;
  case Key::I:
    m_nodes.setInstancing(!m_nodes.instancing());
    return true;
  case Key::M:
    m_nodes.setGeomorph(!m_nodes.geomorph());
    return true;
  case Key::T:
    m_nodes.nextColouring();
    return true;
  case Key::EQUAL:
  case Key::PAD_ADD:
    m_nodes.setPrecision(std::min(m_nodes.precision() * kStep, kMostPrecision));
    return true;
  case Key::MINUS:
  case Key::PAD_SUBTRACT:
    m_nodes.setPrecision(std::max(m_nodes.precision() / kStep, 1.0));
    return true;
  case Key::COMMA:
  case Key::PERIOD: {
    const double step = key == Key::PERIOD ? kStep : 1 / kStep;
    const double now = m_nodes.pixelError() > 0 ? m_nodes.pixelError() * step : kFirstPixelError;
    m_nodes.setPixelError(std::clamp(now, kLeastPixelError, kMostPixelError));
    return true;
  }
  default:
    return false;
  }
}

std::vector<std::string> TeViewControls::helpLines() {
  return {"F1, /  this help",
          "H  statistics",
          "W, F3, X  wireframe",
          "C, F2  second camera",
          "I  instanced or classic drawing",
          "M  geomorphing",
          "T  next colouring",
          "+, -  precision",
          ", .  wanted pixel error less, more",
          "P, Space  pause the flight",
          "F12, G  picture into a file",
          "Esc  quit"};
}
