#include "nodes/lod/SoTeLodTerrain.h"

#include "generators/base/TeText.h"
#include "generators/elevation/TeElevationOptions.h"
#include "nodes/TeCoinVectors.h"
#include "nodes/lod/drawing/TeLodRays.h"
#include "nodes/seamless/TeSeamlessHeightFile.h"

#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLLazyElement.h>
#include <Inventor/elements/SoMultiTextureEnabledElement.h>
#include <Inventor/elements/SoOverrideElement.h>
#include <Inventor/misc/SoState.h>

#include <algorithm>
#include <cmath>

SO_NODE_SOURCE(SoTeLodTerrain)

void SoTeLodTerrain::initClass() {
  SoTeLodShape::initClass();
  if (classTypeId == SoType::badType())
    PRIVATE_COMMON_INIT_CODE(SoTeLodTerrain, "TeLodTerrain", &SoTeLodTerrain::createInstance, SoTeLodShape);
}

SoTeLodTerrain::SoTeLodTerrain() : SoTeLodShape(1) {
  SO_NODE_CONSTRUCTOR(SoTeLodTerrain);
  SO_NODE_ADD_FIELD(method, ("seamless"));
  SO_NODE_ADD_FIELD(dial, (0));
  SO_NODE_ADD_FIELD(maxTriangles, (1 << 22));
  SO_NODE_ADD_FIELD(slice, (0));
  SO_NODE_DEFINE_ENUM_VALUE(Submission, IMMEDIATE);
  SO_NODE_DEFINE_ENUM_VALUE(Submission, VERTEX_ARRAYS);
  SO_NODE_DEFINE_ENUM_VALUE(Submission, INDEXED_ARRAYS);
  SO_NODE_DEFINE_ENUM_VALUE(Submission, VBO_STATIC);
  SO_NODE_DEFINE_ENUM_VALUE(Submission, VBO_DYNAMIC);
  SO_NODE_DEFINE_ENUM_VALUE(Submission, VBO_STREAM);
  SO_NODE_DEFINE_ENUM_VALUE(Submission, DISPLAY_LISTS);
  SO_NODE_SET_SF_ENUM_TYPE(submission, Submission);
  SO_NODE_ADD_FIELD(submission, (VBO_STATIC));
  SO_NODE_DEFINE_ENUM_VALUE(Coloring, PLAIN);
  SO_NODE_DEFINE_ENUM_VALUE(Coloring, HEIGHT);
  SO_NODE_SET_SF_ENUM_TYPE(coloring, Coloring);
  SO_NODE_ADD_FIELD(coloring, (PLAIN));
}

SoTeLodTerrain::~SoTeLodTerrain() = default;

void SoTeLodTerrain::setField(TeLodFieldPtr field) {
  m_givenField = std::move(field);
  forgetHeights();
  touch();
}

void SoTeLodTerrain::copyContents(const SoFieldContainer* from, SbBool copyConnections) {
  inherited::copyContents(from, copyConnections);
  m_givenField = static_cast<const SoTeLodTerrain*>(from)->m_givenField;
}

TeStatus SoTeLodTerrain::load(bool&) {
  m_viewers.clear();
  m_field.reset();
  m_map = givenHeights();
  m_extent = {};
  if (m_givenField)
    return {};
  if (!m_map) {
    const TeResult<std::string> path = heightPath();
    if (!path)
      return path.error();
    const TeResult<double> unit = teVerticalUnit(verticalUnit.getValue().getString());
    if (!unit)
      return TeError{"verticalUnit: " + unit.error().message};
    TeResult<TeSeamlessHeightFile> file = TeSeamlessHeightFile::read(*path, *unit);
    if (!file)
      return file.error();
    m_map = std::make_shared<const TeHeightMap>(std::move(file->map));
    m_extent.isRaw = file->isRaw && *unit == 0;
    if (file->spacing > 0)
      m_extent.spacing = file->spacing;
  }
  m_extent.cells = std::max(1, m_map->width() - 1);
  return {};
}

TeStatus SoTeLodTerrain::build(bool&) {
  TeLodScene scene;
  scene.method = method.getValue().getString();
  for (const TeStatus& status : {place(scene), readAccuracy(scene), readLook(scene)})
    if (!status)
      return status;
  const TeResult<TeNodePtr<SoCamera>> camera = readLodCamera();
  if (!camera)
    return camera.error();
  scene.lodCamera = *camera;
  const TeStatus status = m_viewers.setScene(std::move(scene));
  return status ? TeStatus() : TeStatus(TeError{"method: " + status.error().message});
}

TeStatus SoTeLodTerrain::place(TeLodScene& scene) {
  if (m_givenField) {
    const glm::dvec3 from = teToGlm(origin.getValue());
    if (!std::isfinite(from.x + from.y + from.z))
      return TeError{"origin is not finite"};
    scene.field = m_givenField;
    scene.offset = -from;
    return {};
  }
  const TeResult<TeLodField::Placement> placement = m_extent.place(teToGlm(size.getValue()), middle());
  if (!placement)
    return placement.error();
  // Methods are made for a field at 0: moving it makes nothing anew.
  const TeLodField::Placement there{glm::dvec3(0), placement->spacing, placement->heightScale};
  if (!m_field || m_field->spacing() != there.spacing || m_field->heightScale() != there.heightScale) {
    const TeResult<TeLodFieldPtr> made = TeLodField::create(m_map, there);
    if (!made)
      return made.error();
    m_field = *made;
  }
  scene.field = m_field;
  scene.offset = placement->corner;
  return {};
}

TeStatus SoTeLodTerrain::readAccuracy(TeLodScene& scene) const {
  scene.accuracy.pixelError = double(pixelError.getValue());
  scene.accuracy.dial = double(dial.getValue());
  scene.accuracy.geomorph = geomorph.getValue();
  scene.accuracy.maxTriangles = maxTriangles.getValue();
  scene.slice = double(slice.getValue());
  if (!(scene.accuracy.pixelError >= 0) || !std::isfinite(scene.accuracy.pixelError))
    return TeError{"pixelError " + teNumberText(scene.accuracy.pixelError) + " is not a number from 0"};
  if (!(scene.accuracy.dial >= 0) || !std::isfinite(scene.accuracy.dial))
    return TeError{"dial " + teNumberText(scene.accuracy.dial) + " is not a number from 0"};
  if (scene.accuracy.maxTriangles < 1)
    return TeError{"maxTriangles " + std::to_string(scene.accuracy.maxTriangles) + " is not a number from 1"};
  if (!(scene.slice >= 0) || !std::isfinite(scene.slice))
    return TeError{"slice " + teNumberText(scene.slice) + " is not a number from 0"};
  return {};
}

TeStatus SoTeLodTerrain::readLook(TeLodScene& scene) const {
  const int way = submission.getValue();
  if (way < IMMEDIATE || way > DISPLAY_LISTS)
    return TeError{"submission " + std::to_string(way) + " is none of the seven"};
  scene.look.submission = TeLodSubmission(way);
  scene.look.wireframe = wireframe.getValue();
  const int colours = coloring.getValue();
  if (colours != PLAIN && colours != HEIGHT)
    return TeError{"coloring " + std::to_string(colours) + " is none of the two"};
  const double scale = scene.field ? scene.field->heightScale() : 1;
  if (colours == HEIGHT && scene.field)
    scene.look.colours = TeSeamlessSlopeColours::forHeights(float(double(scene.field->lowest()) * scale),
                                                            float(double(scene.field->highest()) * scale));
  return {};
}

bool SoTeLodTerrain::setColours(SoState* state, const std::vector<std::uint32_t>& colours) {
  if (colours.empty() || SoOverrideElement::getDiffuseColorOverride(state))
    return false;
  SoLazyElement::setPacked(state, this, std::int32_t(colours.size()), colours.data(), FALSE);
  return true;
}

TeStatus SoTeLodTerrain::draw(SoGLRenderAction* action) {
  static const std::vector<std::uint32_t> white{0xFFFFFFFF};
  SoState* state = action->getState();
  state->push();
  SoMultiTextureEnabledElement::disableAll(state);
  const bool hasColours = m_viewers.scene().look.colours && setColours(state, white);
  sendMaterial(action);
  const TeStatus status = m_viewers.draw(action, hasColours);
  if (hasColours)
    SoGLLazyElement::getInstance(state)->reset(state, SoLazyElement::DIFFUSE_MASK);
  state->pop();
  return status;
}

void SoTeLodTerrain::emitTriangles(SoAction* action) {
  const TeLodScene& scene = m_viewers.scene();
  const TeLodField& field = *scene.field;
  const TeLodArrayMaker maker(field, glm::dvec3(0), scene.look.colours ? &*scene.look.colours : nullptr);
  SoState* state = action->getState();
  SoPrimitiveVertex primitive;
  std::vector<std::uint32_t> colours;
  m_viewers.forEachPart(action, [&](const TeLodMesh& part) {
    state->push();
    colours.clear();
    if (scene.look.colours)
      for (const TeLodVertex& vertex : part.vertices) {
        const glm::vec3 colour = maker.colour(vertex, maker.normal(vertex));
        colours.push_back(SbColor(colour.x, colour.y, colour.z).getPackedValue());
      }
    const bool hasColours = setColours(state, colours);
    beginShape(action, TRIANGLES);
    const auto give = [&](std::uint32_t index) {
      const TeLodVertex& vertex = part.vertices[index];
      const glm::vec3 normal = maker.normal(vertex);
      primitive.setPoint(teToCoin(field.position(vertex) + scene.offset));
      primitive.setNormal(SbVec3f(normal.x, normal.y, normal.z));
      primitive.setTextureCoords(SbVec4f(float(vertex.column) / float(field.cells()),
                                         float(vertex.row) / float(field.cells()), 0, 1));
      if (hasColours)
        primitive.setMaterialIndex(int(index));
      shapeVertex(&primitive);
    };
    for (const std::uint32_t index : part.indices)
      give(index);
    for (const std::uint32_t index : part.skirts)
      give(index);
    endShape();
    state->pop();
  });
}

void SoTeLodTerrain::pickTriangles(SoRayPickAction* action) {
  TeLodRays(*this, *action, m_viewers, teToGlm(origin.getValue())).pick();
}
