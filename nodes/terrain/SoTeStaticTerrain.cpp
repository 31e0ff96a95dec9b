#include "nodes/terrain/SoTeStaticTerrain.h"

#include "generators/TeGeneratorRegistry.h"
#include "nodes/TeSceneFile.h"
#include "nodes/terrain/SoTeTerrainDetail.h"
#include "nodes/terrain/TeElevationTerrain.h"

#include <Inventor/SbLine.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoGetMatrixAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/elements/SoPickStyleElement.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/misc/SoState.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

SO_NODE_SOURCE(SoTeStaticTerrain)

namespace {

constexpr int kMostHits = 1000;    ///< along one ray
constexpr int kFillDistance = 100; ///< posts

TeResult<std::uint64_t> parseSeed(const SbString& text) {
  std::uint64_t value = 0;
  const char* begin = text.getString();
  const char* end = begin + text.getLength();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end)
    return TeError{"seed \"" + std::string(begin) +
                   "\" is not a whole number from 0 to 18446744073709551615"};
  return value;
}

glm::vec3 colour(const SbColor& colour) { return {colour[0], colour[1], colour[2]}; }

} // namespace

void SoTeStaticTerrain::initClass() {
  if (classTypeId == SoType::badType())
    PRIVATE_COMMON_INIT_CODE(SoTeStaticTerrain, "TeStaticTerrain", &SoTeStaticTerrain::createInstance,
                             SoNode);
}

SoTeStaticTerrain::SoTeStaticTerrain() {
  SO_NODE_CONSTRUCTOR(SoTeStaticTerrain);
  SO_NODE_ADD_FIELD(seed, ("0"));
  SO_NODE_ADD_FIELD(generator, (TeGeneratorRegistry::kDefaultGenerator));
  SO_NODE_ADD_EMPTY_MFIELD(filters);
  SO_NODE_ADD_FIELD(file, (""));
  SO_NODE_ADD_FIELD(verticalUnit, ("auto"));
  SO_NODE_ADD_FIELD(fillVoids, (FALSE));
  SO_NODE_ADD_FIELD(native, (FALSE));
  SO_NODE_DEFINE_ENUM_VALUE(Blending, LINEAR);
  SO_NODE_DEFINE_ENUM_VALUE(Blending, SMOOTH);
  SO_NODE_SET_SF_ENUM_TYPE(blending, Blending);
  SO_NODE_ADD_FIELD(blending, (SMOOTH));
  SO_NODE_ADD_FIELD(samples, (65));
  SO_NODE_ADD_FIELD(spacing, (0.0));
  SO_NODE_ADD_FIELD(block, (3));
  SO_NODE_ADD_FIELD(center, (0.0, 0.0));
  SO_NODE_ADD_FIELD(verticalScale, (1.0f));
  SO_NODE_ADD_FIELD(water, (FALSE));
  SO_NODE_ADD_FIELD(waterLevel, (0.0f));
  SO_NODE_ADD_EMPTY_MFIELD(colors);
  SO_NODE_ADD_EMPTY_MFIELD(colorHeights);
  SO_NODE_ADD_FIELD(image, (""));
  SO_NODE_ADD_FIELD(parts, (FALSE));
  m_children = std::make_unique<SoChildList>(this);
}

SoTeStaticTerrain::~SoTeStaticTerrain() = default;

const TeStaticBlock* SoTeStaticTerrain::getBlock() {
  update();
  return m_block.get();
}

SoSeparator* SoTeStaticTerrain::getGraph() {
  update();
  return m_children->getLength() > 0 ? static_cast<SoSeparator*>((*m_children)[0]) : nullptr;
}

const std::string& SoTeStaticTerrain::getError() {
  update();
  return m_error;
}

void SoTeStaticTerrain::update() {
  if (m_isCurrent)
    return;
  // Whoever watches this node was told when the field changed.
  const SbBool notified = enableNotify(FALSE);
  m_children->truncate(0);
  m_block.reset();
  m_error.clear();
  if (TeStatus status = build(); !status) {
    m_children->truncate(0);
    m_block.reset();
    m_error = status.error().message;
    SoDebugError::postWarning("TeStaticTerrain", "%s", m_error.c_str());
  }
  enableNotify(notified);
  m_isCurrent = true; // only now: children that come and go notify as fields do
}

TeStatus SoTeStaticTerrain::build() {
  glm::dvec2 middle(center.getValue()[0], center.getValue()[1]);
  TeResult<TeWorld> world = makeWorld(middle);
  if (!world)
    return world.error();
  TeResult<TeStaticBlock> made = TeStaticBlock::build(std::move(*world), middle, block.getValue());
  if (!made)
    return made.error();
  m_block = std::make_unique<TeStaticBlock>(std::move(*made));
  const TeResult<TeBlockStyle> style = makeStyle(*m_block);
  if (!style)
    return style.error();
  const TeResult<TeNodePtr<SoSeparator>> graph = teBlockGraph(*m_block, *style);
  if (!graph)
    return graph.error();
  m_children->append(graph->get());
  return {};
}

TeResult<TeWorld> SoTeStaticTerrain::makeWorld(glm::dvec2& middle) const {
  TeWorld world;
  const TeResult<std::uint64_t> number = parseSeed(seed.getValue());
  if (!number)
    return number.error();
  world.seed = *number;
  double metres = spacing.getValue();
  TeResult<TeHeightSourcePtr> source = makeSource(metres, middle);
  if (!source)
    return source.error();
  const TeResult<TeLattice> lattice = TeLattice::create(samples.getValue(), metres);
  if (!lattice)
    return lattice.error();
  world.lattice = *lattice;
  world.sources = std::make_shared<TeSingleSource>(std::move(*source));
  world.blending = blending.getValue() == LINEAR ? TeBlendProfile::Linear : TeBlendProfile::Smooth;
  return world;
}

TeResult<TeHeightSourcePtr> SoTeStaticTerrain::makeSource(double& metres, glm::dvec2& middle) const {
  const TeGeneratorRegistry& registry = TeGeneratorRegistry::instance();
  std::vector<std::string> specifications;
  for (int i = 0; i < filters.getNum(); i++)
    specifications.push_back(filters[i].getString());
  if (file.getValue().getLength() == 0) {
    if (metres == 0)
      metres = 1;
    return registry.source(generator.getValue().getString(), specifications);
  }

  TeElevationTerrainOptions options;
  options.file = teBesideScene(file.getValue().getString(), m_folder);
  const TeResult<double> unit = teVerticalUnit(verticalUnit.getValue().getString());
  if (!unit)
    return TeError{"verticalUnit: " + unit.error().message};
  options.reading.verticalUnit = *unit;
  options.reading.fillDistance = fillVoids.getValue() ? kFillDistance : 0;
  options.native = native.getValue();
  options.patches = block.getValue();
  options.samples = samples.getValue();
  options.spacing = metres;
  TeResult<TeElevationTerrain> terrain = TeElevationTerrain::open(options);
  if (!terrain)
    return terrain.error();
  metres = terrain->spacing;
  middle += terrain->centre;
  return registry.filtered(terrain->source, specifications);
}

TeResult<TeBlockStyle> SoTeStaticTerrain::makeStyle(const TeStaticBlock& block) const {
  TeBlockStyle style;
  TeSurfaceColours ground = TeSurfaceColours::forHeights(block.mean(), block.maximum());
  if (colors.getNum() > 0)
    ground.grass = colour(colors[0]);
  if (colors.getNum() > 1)
    ground.rock = colour(colors[1]);
  if (colors.getNum() > 2)
    ground.snow = colour(colors[2]);
  if (colors.getNum() > 3)
    return TeError{"colors: grass, rock and snow are three, not " + std::to_string(colors.getNum())};
  if (colorHeights.getNum() != 0 && colorHeights.getNum() != 2)
    return TeError{"colorHeights: two heights are needed, not " + std::to_string(colorHeights.getNum())};
  if (colorHeights.getNum() == 2) {
    ground.rockLine = colorHeights[0];
    ground.snowLine = colorHeights[1];
    if (!std::isfinite(ground.rockLine) || !std::isfinite(ground.snowLine))
      return TeError{"colorHeights are not finite"};
  }
  for (int i = 0; i < colors.getNum(); i++) {
    for (int channel = 0; channel < 3; channel++) {
      if (!(colors[i][channel] >= 0 && colors[i][channel] <= 1))
        return TeError{"colors: value " + std::to_string(colors[i][channel]) + " is not from 0 to 1"};
    }
  }
  style.colours = ground;
  style.showParts = parts.getValue();
  style.verticalScale = verticalScale.getValue();
  if (water.getValue()) {
    if (!std::isfinite(waterLevel.getValue()))
      return TeError{"waterLevel is not finite"};
    style.water = waterLevel.getValue();
  }
  if (image.getValue().getLength() > 0) {
    TeResult<TePicture> picture = TePicture::readPng(teBesideScene(image.getValue().getString(), m_folder));
    if (!picture)
      return picture.error();
    style.image = std::move(*picture);
  }
  return style;
}

SbBool SoTeStaticTerrain::readInstance(SoInput* input, unsigned short flags) {
  if (const char* file = input->getCurFileName())
    m_folder = std::filesystem::path(file).parent_path().string();
  return inherited::readInstance(input, flags);
}

void SoTeStaticTerrain::copyContents(const SoFieldContainer* from, SbBool copyConnections) {
  inherited::copyContents(from, copyConnections);
  m_folder = static_cast<const SoTeStaticTerrain*>(from)->m_folder;
  m_isCurrent = false;
}

void SoTeStaticTerrain::notify(SoNotList* list) {
  const SoNotRec* last = list->getLastRec();
  if (last && last->getType() == SoNotRec::CONTAINER)
    m_isCurrent = false;
  inherited::notify(list);
}

void SoTeStaticTerrain::doAction(SoAction* action) {
  update();
  int count = 0;
  const int* indices = nullptr;
  if (action->getPathCode(count, indices) == SoAction::IN_PATH)
    m_children->traverseInPath(action, count, indices);
  else
    m_children->traverse(action);
}

void SoTeStaticTerrain::callback(SoCallbackAction* action) { doAction(action); }
void SoTeStaticTerrain::GLRender(SoGLRenderAction* action) { doAction(action); }
void SoTeStaticTerrain::getBoundingBox(SoGetBoundingBoxAction* action) { doAction(action); }
void SoTeStaticTerrain::getPrimitiveCount(SoGetPrimitiveCountAction* action) { doAction(action); }

void SoTeStaticTerrain::getMatrix(SoGetMatrixAction* action) {
  int count = 0;
  const int* indices = nullptr;
  if (action->getPathCode(count, indices) == SoAction::IN_PATH)
    m_children->traverseInPath(action, count, indices);
}

void SoTeStaticTerrain::search(SoSearchAction* action) {
  inherited::search(action);
  if (!action->isFound())
    doAction(action);
}

// Coin calls rayPick() by itself only for shapes.
void SoTeStaticTerrain::pick(SoPickAction* action) {
  if (action->isOfType(SoRayPickAction::getClassTypeId()))
    rayPick(static_cast<SoRayPickAction*>(action));
  else
    doAction(action);
}

void SoTeStaticTerrain::rayPick(SoRayPickAction* action) {
  update();
  SoState* state = action->getState();
  if (!m_block || !action->hasWorldSpaceRay() ||
      SoPickStyleElement::get(state) == SoPickStyleElement::UNPICKABLE)
    return;
  action->setObjectSpace();
  const double scale = verticalScale.getValue();
  const glm::dvec2 middle = m_block->centre();
  const SbVec3f& from = action->getLine().getPosition();
  const SbVec3f& along = action->getLine().getDirection();
  const glm::dvec3 direction(along[0], along[1], along[2] / scale);
  glm::dvec3 origin(middle.x + from[0], middle.y + from[1], from[2] / scale);

  // Hits before the near plane do not count; with pickAll all that follow do.
  for (int i = 0; i < kMostHits; i++) {
    const std::optional<TeRayHit> hit = m_block->intersect(origin, direction);
    if (!hit)
      return;
    const SbVec3f point(float(hit->position.x - middle.x), float(hit->position.y - middle.y),
                        float(hit->position.z * scale));
    SoPickedPoint* picked = action->isBetweenPlanes(point) ? action->addIntersection(point) : nullptr;
    if (picked) {
      SbVec3f normal(float(hit->normal.x), float(hit->normal.y), float(hit->normal.z / scale));
      normal.normalize();
      picked->setObjectNormal(normal);
      picked->setDetail(new SoTeTerrainDetail(*hit), this);
      if (!action->isPickAll())
        return;
    }
    // On to just behind the surface: a millionth of a cell, but no less than coordinates can tell apart.
    const double reach = std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)});
    const double step = std::max(1e-6 * m_block->lattice().spacing(), 1e-15 * reach);
    origin += direction * (hit->distance + step / glm::length(direction));
  }
}
