#include "engine/hud/TeHud.h"

#include "engine/hud/TeTextPanel.h"
#include "nodes/TeOverlay.h"

#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransparencyType.h>

#include <algorithm>

namespace {

constexpr int kInset = 10; ///< of the lines from the picture's corner, pixels

/// At most kMaxColumns characters that the HUD can show.
std::string shownText(const std::string& line) {
  std::string shown;
  int columns = 0;
  for (std::size_t i = 0; i < line.size() && columns < TeHud::kMaxColumns; ++columns) {
    const unsigned char c = static_cast<unsigned char>(line[i++]);
    if (c < 0x80) {
      shown += c >= 0x20 && c != 0x7F ? char(c) : '?';
      continue;
    }
    std::string character(1, char(c));
    while (i < line.size() && (static_cast<unsigned char>(line[i]) & 0xC0) == 0x80)
      character += line[i++];
    shown += character == "°" ? character : "?";
  }
  return shown;
}

std::vector<std::string> shownTexts(const std::vector<std::string>& lines) {
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < lines.size() && i < std::size_t(TeHud::kMaxLines); ++i)
    shown.push_back(shownText(lines[i]));
  return shown;
}

/// What is drawn as text and flat rectangles over the picture, whatever the scene's state.
SoSeparator* makeGraph() {
  auto* graph = new SoSeparator;
  teAddOverlayState(*graph);
  auto* transparency = new SoTransparencyType;
  transparency->value = SoTransparencyType::BLEND;
  graph->addChild(transparency);
  return graph;
}

} // namespace

TeHud::TeHud() : m_lines(std::make_unique<TeTextPanel>()), m_help(std::make_unique<TeTextPanel>()) {
  m_help->setShown(false);
}

TeHud::~TeHud() {
  if (m_root && m_root->findChild(m_graph.get()) >= 0)
    m_root->removeChild(m_graph.get());
}

TeStatus TeHud::attach(SoSeparator* root, SoOrthographicCamera* camera) {
  if (!root || !camera)
    return TeError{root ? "TeHud: no camera given" : "TeHud: no root given"};
  if (m_root)
    return TeError{"TeHud: it has a root already"};
  m_root = root;
  m_camera = camera;
  if (root->findChild(camera) < 0)
    root->insertChild(camera, 0);
  m_graph = TeNodePtr<SoSeparator>(makeGraph());
  m_graph->addChild(m_lines->node());
  m_graph->addChild(m_help->node());
  root->addChild(m_graph.get());
  ++m_changes;
  arrange();
  return {};
}

void TeHud::setViewport(int width, int height) {
  width = std::max(width, 1);
  height = std::max(height, 1);
  if (width == m_width && height == m_height)
    return;
  m_width = width;
  m_height = height;
  arrange();
}

void TeHud::arrange() {
  if (m_camera && m_camera->height.getValue() != float(m_height)) {
    m_camera->height = float(m_height);
    ++m_changes;
  }
  const SbVec3f middle(0.5f * float(m_width), 0.5f * float(m_height), 1);
  if (m_camera && m_camera->position.getValue() != middle) {
    m_camera->position = middle;
    m_camera->orientation = SbRotation::identity();
    m_camera->nearDistance = 0;
    m_camera->farDistance = 2;
    ++m_changes;
  }
  m_changes += m_lines->setTopLeft({kInset, m_height - kInset});
  const glm::ivec2 help = m_help->size();
  m_changes += m_help->setTopLeft({(m_width - help.x) / 2, (m_height + help.y) / 2});
}

void TeHud::setLines(const std::vector<std::string>& lines) {
  m_changes += m_lines->setLines(shownTexts(lines));
}

void TeHud::setHelp(const std::vector<std::string>& lines) {
  m_changes += m_help->setLines(shownTexts(lines));
  updateShown();
  arrange();
}

void TeHud::showHelp(bool shown) {
  m_helpShown = shown;
  updateShown();
}

void TeHud::setVisible(bool visible) {
  m_visible = visible;
  updateShown();
}

void TeHud::updateShown() {
  const bool help = m_helpShown && !m_help->lines().empty();
  m_changes += m_help->setShown(m_visible && help);
  m_changes += m_lines->setShown(m_visible && !help);
}

const std::vector<std::string>& TeHud::lines() const { return m_lines->lines(); }
