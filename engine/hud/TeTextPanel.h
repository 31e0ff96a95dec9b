#pragma once

#include "nodes/TeNodePtr.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

class SoSeparator;
class SoSwitch;
class SoText2;
class SoTranslation;
class SoVertexProperty;

/// A translucent dark rectangle with lines of light text of a fixed width. Coordinates are pixels.
class TeTextPanel {
public:
  static constexpr int kLineHeight = 17;
  static constexpr int kColumnWidth = 8;
  static constexpr int kMargin = 8; ///< around the text

  TeTextPanel();

  SoSwitch* node() const { return m_switch.get(); }
  // All that is set waits until it is shown; true if nodes changed.

  /// Lines of printable text.
  bool setLines(const std::vector<std::string>& lines);
  const std::vector<std::string>& lines() const { return m_lines; }
  /// A panel without lines is not shown either.
  bool setShown(bool shown);
  bool setTopLeft(glm::ivec2 place);
  /// Wide enough for the longest line that it has had with this number of lines, so that it does not
  /// flicker with the digits.
  glm::ivec2 size() const;

private:
  bool update();
  void updateText();
  void updateRectangle();

  TeNodePtr<SoSwitch> m_switch;
  SoTranslation* m_place; ///< these belong to m_switch
  SoVertexProperty* m_corners;
  SoText2* m_text;
  std::vector<std::string> m_lines;
  glm::ivec2 m_topLeft{0};
  int m_columns = 0;
  bool m_shown = true;
  bool m_textIsOld = false;
};
