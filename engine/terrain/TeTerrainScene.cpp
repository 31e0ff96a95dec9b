#include "engine/terrain/TeTerrainScene.h"

#include "patchdb/TePatchKey.h"

#include <Inventor/nodes/SoShapeHints.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

TeTerrainScene::TeTerrainScene(const TeLattice& lattice, const glm::dvec3& eye)
    : m_lattice(lattice), m_drawing(std::make_shared<TeMeshDrawing>(glm::dvec2(0))), m_root(new SoSeparator),
      m_style(new SoDrawStyle), m_patches(new SoGroup) {
  m_root->setName("TerraneTerrain");
  // A cache of lists would be thrown away at every change, and the meshes have buffers of their own.
  m_root->renderCaching = SoSeparator::OFF;
  m_root->addChild(m_drawing->translation());
  // No light from behind: where a slope seen from the back shows in a pixel of a ridge, it would be dark.
  m_root->addChild(new SoShapeHints);
  m_root->addChild(m_style.get());
  m_root->addChild(m_patches.get());
  jump(eye);
}

glm::dvec2 TeTerrainScene::cornerNear(const glm::dvec3& point) const {
  const TeResult<TePatchKey> key = tePatchAt(m_lattice, {point.x, point.y});
  return key ? tePatchOrigin(m_lattice, *key) : glm::dvec2(point.x, point.y);
}

void TeTerrainScene::setOrigin(const glm::dvec3& eye) {
  const glm::dvec2 corner = cornerNear(eye);
  m_origin = {corner.x, corner.y, std::clamp(std::floor(eye.z), -kHighest, kHighest)};
  m_drawing->setWorldOrigin(m_origin);
}

void TeTerrainScene::jump(const glm::dvec3& eye) {
  m_drawing->setAnchor(cornerNear(eye));
  setOrigin(eye);
}

void TeTerrainScene::finishAnchor() {
  if (m_drawing->changesAnchor())
    m_drawing->setAnchor(m_drawing->nextAnchor());
}

bool TeTerrainScene::follow(const glm::dvec3& eye, int reach) {
  const double side = m_lattice.patchSide();
  const bool inWorld(tePatchAt(m_lattice, {eye.x, eye.y}));
  const auto distance = [](const glm::dvec2& a, const glm::dvec3& b) {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
  };
  if (m_drawing->changesAnchor()) {
    const TeMeshDrawing::Frame& frame = m_drawing->frame();
    m_undrawn = frame.meshesDrawn + frame.meshesCulled > 0 ? 0 : m_undrawn + 1;
    if (m_drawing->nextAnchorReady())
      m_drawing->commitAnchor();
    else if (m_undrawn >= kUndrawnTicks)
      finishAnchor();
  } else if (inWorld &&
             distance(m_drawing->anchor(), eye) > side * std::max(kAnchorPatches, 4.0 * (reach + 2))) {
    m_drawing->beginAnchor(cornerNear(eye));
    m_undrawn = 0;
  }
  if (!inWorld)
    return false;
  const glm::dvec3 away = glm::abs(eye - m_origin);
  if (std::max({away.x, away.y, away.z}) <= side * kOriginPatches)
    return false;
  setOrigin(eye);
  return true;
}

void TeTerrainScene::add(SoGroup* patch) { m_patches->addChild(patch); }

void TeTerrainScene::remove(SoGroup* patch) {
  if (const int index = m_patches->findChild(patch); index >= 0)
    m_patches->removeChild(index);
}

void TeTerrainScene::setWireframe(bool wireframe) {
  m_style->style = wireframe ? SoDrawStyle::LINES : SoDrawStyle::FILLED;
}
