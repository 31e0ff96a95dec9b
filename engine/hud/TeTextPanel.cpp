#include "engine/hud/TeTextPanel.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoFont.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoText2.h>
#include <Inventor/nodes/SoTranslation.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include <algorithm>

namespace {

constexpr float kFontSize = 14;
constexpr int kBaseline = 13;                      ///< of the first line, below the top of the text
constexpr std::uint32_t kPanelColour = 0x0C1420B0; ///< RGBA
const SbColor kTextColour(0.93f, 0.96f, 0.90f);

int columnsOf(const std::string& line) {
  // Continuation bytes of UTF-8 take no column.
  return int(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

} // namespace

TeTextPanel::TeTextPanel()
    : m_switch(new SoSwitch), m_place(new SoTranslation), m_corners(new SoVertexProperty),
      m_text(new SoText2) {
  auto* panel = new SoSeparator;
  m_switch->addChild(panel);
  panel->addChild(m_place);

  m_corners->orderedRGBA = kPanelColour;
  m_corners->materialBinding = SoVertexProperty::OVERALL;
  auto* rectangle = new SoFaceSet;
  rectangle->vertexProperty = m_corners;
  rectangle->numVertices = 4;
  panel->addChild(rectangle);

  auto* colour = new SoBaseColor;
  colour->rgb = kTextColour;
  panel->addChild(colour);
  auto* font = new SoFont;
  font->name = "monospace";
  font->size = kFontSize;
  panel->addChild(font);
  auto* baseline = new SoTranslation;
  baseline->translation.setValue(kMargin, -(kMargin + kBaseline), 0);
  panel->addChild(baseline);
  m_text->spacing = kLineHeight / kFontSize;
  panel->addChild(m_text);
}

bool TeTextPanel::setLines(const std::vector<std::string>& lines) {
  if (lines == m_lines)
    return false;
  if (lines.size() != m_lines.size())
    m_columns = 0;
  m_lines = lines;
  for (const std::string& line : lines)
    m_columns = std::max(m_columns, columnsOf(line));
  m_textIsOld = true;
  return update();
}

bool TeTextPanel::setShown(bool shown) {
  m_shown = shown;
  return update();
}

bool TeTextPanel::setTopLeft(glm::ivec2 place) {
  m_topLeft = place;
  return update();
}

glm::ivec2 TeTextPanel::size() const {
  return {m_columns * kColumnWidth + 2 * kMargin, int(m_lines.size()) * kLineHeight + 2 * kMargin};
}

bool TeTextPanel::update() {
  const bool visible = m_shown && !m_lines.empty();
  bool changed = false;
  if (visible && m_textIsOld) {
    updateText();
    changed = true;
  }
  const SbVec3f place(float(m_topLeft.x), float(m_topLeft.y), 0);
  if (visible && m_place->translation.getValue() != place) {
    m_place->translation = place;
    changed = true;
  }
  const int child = visible ? SO_SWITCH_ALL : SO_SWITCH_NONE;
  if (m_switch->whichChild.getValue() != child) {
    m_switch->whichChild = child;
    changed = true;
  }
  return changed;
}

void TeTextPanel::updateText() {
  std::vector<SbString> texts;
  for (const std::string& line : m_lines)
    texts.emplace_back(line.c_str());
  const SbBool notified = m_text->string.enableNotify(FALSE); // once, not for every line
  m_text->string.setNum(int(texts.size()));
  m_text->string.setValues(0, int(texts.size()), texts.data());
  m_text->string.enableNotify(notified);
  m_text->string.touch();
  updateRectangle();
  m_textIsOld = false;
}

void TeTextPanel::updateRectangle() {
  const float width = float(size().x);
  const float height = float(size().y);
  const SbVec3f corners[4] = {{0, -height, 0}, {width, -height, 0}, {width, 0, 0}, {0, 0, 0}};
  if (m_corners->vertex.getNum() == 4 && m_corners->vertex[1] == corners[1])
    return;
  m_corners->vertex.setValues(0, 4, corners);
}
