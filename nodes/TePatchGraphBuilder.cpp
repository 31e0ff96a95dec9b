#include "nodes/TePatchGraphBuilder.h"

#include "nodes/terrain/TeMeshVertices.h"

#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoIndexedTriangleStripSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoNormal.h>
#include <Inventor/nodes/SoPackedColor.h>
#include <Inventor/nodes/SoTextureCoordinate2.h>

#include <cassert>

TePatchGraphBuilder::TePatchGraphBuilder(glm::dvec2 anchor)
    : m_anchor(anchor), m_translation(new SoTranslation), m_hints(new SoShapeHints),
      m_normalBinding(new SoNormalBinding), m_materialBinding(new SoMaterialBinding),
      m_textureBinding(new SoTextureCoordinateBinding) {
  m_hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  m_normalBinding->value = SoNormalBinding::PER_VERTEX_INDEXED;
  m_materialBinding->value = SoMaterialBinding::PER_VERTEX_INDEXED;
  m_textureBinding->value = SoTextureCoordinateBinding::PER_VERTEX_INDEXED;
  const SbColor partColours[] = {{0.45f, 0.6f, 0.35f}, {0.85f, 0.6f, 0.2f}, {0.75f, 0.25f, 0.25f}};
  for (std::size_t i = 0; i < m_partColours.size(); i++) {
    m_partColours[i] = TeNodePtr<SoBaseColor>(new SoBaseColor);
    m_partColours[i]->rgb = partColours[i];
  }
}

void TePatchGraphBuilder::setWorldOrigin(glm::dvec3 origin) {
  m_translation->translation.setValue(float(m_anchor.x - origin.x), float(m_anchor.y - origin.y),
                                      float(-origin.z));
}

TeStatus TePatchGraphBuilder::setImage(const TePicture& image, const TeWorldRect& rect) {
  if (image.width < 1 || image.height < 1 || image.width > TePicture::kMaxSide ||
      image.height > TePicture::kMaxSide || image.rgba.size() != std::size_t(4) * image.width * image.height)
    return TeError{"image of " + std::to_string(image.width) + "x" + std::to_string(image.height) +
                   " cannot be draped"};
  if (!(rect.northEast.x > rect.southWest.x && rect.northEast.y > rect.southWest.y))
    return TeError{"image: the rectangle that it covers is empty"};
  m_image = TeNodePtr<SoTexture2>(new SoTexture2);
  m_image->image.setValue(SbVec2s(short(image.width), short(image.height)), 4, image.rgba.data());
  m_image->wrapS = SoTexture2::CLAMP;
  m_image->wrapT = SoTexture2::CLAMP;
  m_imageRect = rect;
  return {};
}

TeNodePtr<SoSeparator> TePatchGraphBuilder::build(const TePatchMesh& mesh) const {
  assert(mesh.normals.size() == mesh.positions.size());
  TeNodePtr<SoSeparator> piece(new SoSeparator);
  if (mesh.strips.empty())
    return piece;
  piece->addChild(m_translation.get());
  piece->addChild(m_hints.get());
  piece->addChild(m_normalBinding.get());
  if (m_showParts)
    piece->addChild(m_partColours[std::size_t(mesh.part)].get());
  else if (m_image)
    addTextureCoordinates(*piece, mesh);
  else
    addColours(*piece, mesh);

  auto* coordinates = new SoCoordinate3;
  coordinates->point.setNum(int(mesh.positions.size()));
  SbVec3f* point = coordinates->point.startEditing();
  for (const glm::vec3& position : mesh.positions) {
    const glm::vec3 vertex = teVertexPosition(mesh, position, m_anchor);
    (point++)->setValue(vertex.x, vertex.y, vertex.z);
  }
  coordinates->point.finishEditing();
  piece->addChild(coordinates);

  auto* normals = new SoNormal;
  normals->vector.setNum(int(mesh.normals.size()));
  SbVec3f* vector = normals->vector.startEditing();
  for (const glm::vec3& normal : mesh.normals)
    (vector++)->setValue(normal.x, normal.y, normal.z);
  normals->vector.finishEditing();
  piece->addChild(normals);

  auto* strips = new SoIndexedTriangleStripSet;
  strips->coordIndex.setValues(0, int(mesh.strips.size()), mesh.strips.data());
  piece->addChild(strips);
  return piece;
}

void TePatchGraphBuilder::addColours(SoSeparator& piece, const TePatchMesh& mesh) const {
  piece.addChild(m_materialBinding.get());
  auto* colours = new SoPackedColor;
  colours->orderedRGBA.setNum(int(mesh.positions.size()));
  std::uint32_t* colour = colours->orderedRGBA.startEditing();
  for (std::size_t i = 0; i < mesh.positions.size(); i++)
    *colour++ = m_colours.packed(mesh.positions[i].z, mesh.normals[i]);
  colours->orderedRGBA.finishEditing();
  piece.addChild(colours);
}

void TePatchGraphBuilder::addTextureCoordinates(SoSeparator& piece, const TePatchMesh& mesh) const {
  piece.addChild(m_image.get());
  piece.addChild(m_textureBinding.get());
  const glm::dvec2 size = m_imageRect.northEast - m_imageRect.southWest;
  auto* coordinates = new SoTextureCoordinate2;
  coordinates->point.setNum(int(mesh.positions.size()));
  SbVec2f* point = coordinates->point.startEditing();
  for (const glm::vec3& position : mesh.positions)
    (point++)->setValue(float((mesh.origin.x + position.x - m_imageRect.southWest.x) / size.x),
                        float((mesh.origin.y + position.y - m_imageRect.southWest.y) / size.y));
  coordinates->point.finishEditing();
  piece.addChild(coordinates);
}

TeNodePtr<SoSeparator> TePatchGraphBuilder::water(const TeWorldRect& rect, float height) const {
  TeNodePtr<SoSeparator> sheet(new SoSeparator);
  sheet->addChild(m_translation.get());
  auto* material = new SoMaterial;
  material->diffuseColor.setValue(0.12f, 0.32f, 0.46f);
  material->specularColor.setValue(0.3f, 0.3f, 0.3f);
  material->shininess = 0.6f;
  material->transparency = 0.3f;
  sheet->addChild(material);
  const float west = float(rect.southWest.x - m_anchor.x);
  const float south = float(rect.southWest.y - m_anchor.y);
  const float east = float(rect.northEast.x - m_anchor.x);
  const float north = float(rect.northEast.y - m_anchor.y);
  const SbVec3f corners[] = {
      {west, south, height}, {east, south, height}, {east, north, height}, {west, north, height}};
  auto* coordinates = new SoCoordinate3;
  coordinates->point.setValues(0, 4, corners);
  sheet->addChild(coordinates);
  auto* normal = new SoNormal;
  normal->vector.setValue(SbVec3f(0, 0, 1));
  sheet->addChild(normal);
  auto* binding = new SoNormalBinding;
  binding->value = SoNormalBinding::OVERALL;
  sheet->addChild(binding);
  auto* faces = new SoFaceSet;
  faces->numVertices.setValue(4);
  sheet->addChild(faces);
  return sheet;
}
