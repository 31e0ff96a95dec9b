#pragma once

#include "apps/terrane-view/TeLodNodes.h"
#include "engine/input/TeKeyEvent.h"

#include <string>
#include <vector>

/// What the user switches by keys while it is shown.
class TeViewControls {
public:
  static constexpr double kStep = 1.25; ///< factor of precision and pixel error

  TeViewControls(const TeViewOptions& options, TeLodNodes& nodes);

  bool wireframe() const { return m_wireframe; }
  bool secondCamera() const { return m_secondCamera; }
  bool statistics() const { return m_statistics; }
  bool help() const { return m_help; }
  bool paused() const { return m_paused; }

  /// True if the key is one of its own.
  bool handleKey(const TeKeyEvent& event);
  static std::vector<std::string> helpLines();

private:
  bool pressed(SoKeyboardEvent::Key key);
  void setWireframe(bool on);

  TeLodNodes& m_nodes;
  bool m_wireframe = false;
  bool m_secondCamera;
  bool m_statistics;
  bool m_help = false;
  bool m_paused = false;
};
