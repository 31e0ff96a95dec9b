#pragma once

#include "generators/base/TeResult.h"
#include "nodes/TeNodePtr.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

class SoOrthographicCamera;
class SoSeparator;
class TeTextPanel;

/// Lines of text over the picture: values in the upper left corner or, while it is asked for, help in the
/// middle.
///
/// Light text on translucent dark panels, drawn without depth test, light and fog after the scene; readable
/// over anything. Coordinates are pixels from the lower left corner. Nodes change only when what they show
/// does; drawing 250 characters with llvmpipe takes about 1 ms. Text is ASCII and "°"; other characters show
/// as '?'. For the thread that makes all Coin calls, after SoDB::init().
class TeHud {
public:
  static constexpr int kMaxLines = 64;
  static constexpr int kMaxColumns = 120; ///< longer lines are cut

  TeHud();
  ~TeHud(); ///< takes its graph out of the root; the camera stays
  TeHud(const TeHud&) = delete;
  TeHud& operator=(const TeHud&) = delete;

  /// Adds the HUD at the end of the root; the camera comes first in the root if it is not in it yet. Once.
  /// Error: no root, no camera, or attached before.
  TeStatus attach(SoSeparator* root, SoOrthographicCamera* camera);
  /// The picture's size; makes the camera show pixels. 1 × 1 and up.
  void setViewport(int width, int height);

  void setLines(const std::vector<std::string>& lines);
  void setHelp(const std::vector<std::string>& lines);
  /// Lines for the program's own keys, which the engine puts at the end of its help.
  void setProgramHelp(std::vector<std::string> lines) { m_programHelp = std::move(lines); }
  const std::vector<std::string>& programHelp() const { return m_programHelp; }
  void showHelp(bool shown);
  bool isHelpShown() const { return m_helpShown; }
  /// All of it, help too.
  void setVisible(bool visible);
  bool isVisible() const { return m_visible; }
  const std::vector<std::string>& lines() const;

  /// How often nodes were changed: a program that sees it unchanged need not draw again.
  int changes() const { return m_changes; }

private:
  void arrange();
  void updateShown();

  TeNodePtr<SoSeparator> m_root;
  TeNodePtr<SoOrthographicCamera> m_camera;
  TeNodePtr<SoSeparator> m_graph; ///< what it has added to the root
  std::unique_ptr<TeTextPanel> m_lines;
  std::unique_ptr<TeTextPanel> m_help;
  std::vector<std::string> m_programHelp;
  int m_width = 1;
  int m_height = 1;
  int m_changes = 0;
  bool m_visible = true;
  bool m_helpShown = false;
};
