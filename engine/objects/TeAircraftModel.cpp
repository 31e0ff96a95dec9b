#include "engine/objects/TeAircraftModel.h"

#include <Inventor/SbColor.h>
#include <Inventor/SbVec3f.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include <cstdint>
#include <vector>

namespace {

const SbColor kWhite(0.9f, 0.9f, 0.88f);
const SbColor kGlass(0.12f, 0.17f, 0.24f);

/// Flat faces of one colour after another.
class Faces {
public:
  void setColour(const SbColor& colour) { m_colour = colour.getPackedValue(); }

  /// Corners counter-clockwise seen from outside.
  void add(const std::vector<SbVec3f>& corners) {
    for (const SbVec3f& corner : corners) {
      m_indices.push_back(int(m_points.size()));
      m_points.push_back(corner);
    }
    m_indices.push_back(SO_END_FACE_INDEX);
    SbVec3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    normal.normalize();
    m_normals.push_back(normal);
    m_colours.push_back(m_colour);
  }

  /// The sides of a body between two outlines of equal length, both counter-clockwise seen from the second.
  void loft(const std::vector<SbVec3f>& first, const std::vector<SbVec3f>& second) {
    for (std::size_t i = 0; i < first.size(); ++i) {
      const std::size_t next = (i + 1) % first.size();
      add({first[i], first[next], second[next], second[i]});
    }
  }

  SoSeparator* graph() const {
    auto* graph = new SoSeparator;
    auto* hints = new SoShapeHints;
    hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
    hints->shapeType = SoShapeHints::SOLID;
    graph->addChild(hints);
    auto* material = new SoMaterial; // the sides in shade are not black
    material->emissiveColor.setValue(0.1f, 0.1f, 0.1f);
    graph->addChild(material);
    auto* vertices = new SoVertexProperty;
    vertices->vertex.setValues(0, int(m_points.size()), m_points.data());
    vertices->normal.setValues(0, int(m_normals.size()), m_normals.data());
    vertices->normalBinding = SoVertexProperty::PER_FACE;
    vertices->orderedRGBA.setValues(0, int(m_colours.size()), m_colours.data());
    vertices->materialBinding = SoVertexProperty::PER_FACE;
    auto* faces = new SoIndexedFaceSet;
    faces->vertexProperty = vertices;
    faces->coordIndex.setValues(0, int(m_indices.size()), m_indices.data());
    graph->addChild(faces);
    return graph;
  }

private:
  std::vector<SbVec3f> m_points;
  std::vector<SbVec3f> m_normals;
  std::vector<int> m_indices;
  std::vector<std::uint32_t> m_colours;
  std::uint32_t m_colour = 0;
};

/// A six-sided section of the body at y, counter-clockwise seen from behind.
std::vector<SbVec3f> section(float y, float halfWidth, float bottom, float top) {
  const float middle = 0.5f * (bottom + top);
  const float half = 0.55f * halfWidth;
  return {{half, y, bottom}, {halfWidth, y, middle},  {half, y, top},
          {-half, y, top},   {-halfWidth, y, middle}, {-half, y, bottom}};
}

/// The outline of a wing at a place of its span, as a flat diamond: front, top, back, bottom, thick along
/// `thickness`.
std::vector<SbVec3f> profile(const SbVec3f& front, float chord, const SbVec3f& thickness) {
  const SbVec3f thick = front - SbVec3f(0, 0.35f * chord, 0);
  return {front, thick + thickness, front - SbVec3f(0, chord, 0), thick - thickness};
}

std::vector<SbVec3f> reversed(const std::vector<SbVec3f>& outline) {
  return {outline.rbegin(), outline.rend()};
}

/// A wing between two profiles, the second one outside, with a tip.
void addWing(Faces& faces, const std::vector<SbVec3f>& inner, const std::vector<SbVec3f>& outer, bool right) {
  // Profiles run front, top, back, bottom: counter-clockwise seen from the right.
  if (right) {
    faces.loft(inner, outer);
    faces.add(outer);
  } else {
    faces.loft(reversed(inner), reversed(outer));
    faces.add(reversed(outer));
  }
}

void addBothWings(Faces& faces, const SbColor& main, const SbColor& tip, const SbVec3f& root, float rootChord,
                  const SbVec3f& end, float endChord, float thickness) {
  constexpr float kTip = 0.78f; // where the tip's colour begins
  for (const bool right : {true, false}) {
    const float side = right ? 1.0f : -1.0f;
    const auto at = [&](float part) {
      const SbVec3f front = root + (end - root) * part;
      return profile({side * front[0], front[1], front[2]}, rootChord + (endChord - rootChord) * part,
                     SbVec3f(0, 0, thickness * (1 - 0.6f * part)));
    };
    faces.setColour(main);
    addWing(faces, at(0), at(kTip), right);
    faces.setColour(tip);
    addWing(faces, at(kTip), at(1), right);
  }
}

} // namespace

SoSeparator* teAircraftModel(const SbColor& colour) {
  Faces faces;
  const std::vector<std::vector<SbVec3f>> sections = {
      section(-4.6f, 0.06f, 0.42f, 0.62f), section(-1.6f, 0.46f, -0.2f, 0.72f),
      section(0.4f, 0.58f, -0.38f, 0.78f), section(2.2f, 0.5f, -0.34f, 0.5f),
      section(3.2f, 0.34f, -0.22f, 0.32f), section(3.8f, 0.08f, 0.0f, 0.12f)};
  faces.setColour(kWhite);
  faces.add(sections.front());
  for (std::size_t i = 1; i + 1 < sections.size(); ++i)
    faces.loft(sections[i], sections[i - 1]);
  faces.setColour(colour);
  faces.loft(sections.back(), sections[sections.size() - 2]);
  faces.add(reversed(sections.back()));

  addBothWings(faces, kWhite, colour, {0.3f, 1.2f, 0.1f}, 1.7f, {4.8f, 0.7f, 0.45f}, 0.9f, 0.13f);
  addBothWings(faces, kWhite, colour, {0.05f, -3.5f, 0.55f}, 1.0f, {1.7f, -3.9f, 0.6f}, 0.6f, 0.06f);

  faces.setColour(colour); // the fin: a wing that stands up
  const auto fin = [](float height, float front, float chord, float thickness) {
    return profile({0, front, height}, chord, {thickness, 0, 0});
  };
  const auto foot = fin(0.5f, -3.0f, 1.6f, 0.08f);
  const auto head = fin(1.8f, -4.0f, 0.7f, 0.04f);
  faces.loft(reversed(foot), reversed(head));
  faces.add(reversed(head));

  faces.setColour(kGlass);
  const std::vector<SbVec3f> sill = {
      {0.32f, 1.9f, 0.5f}, {-0.32f, 1.9f, 0.5f}, {-0.36f, -0.9f, 0.7f}, {0.36f, -0.9f, 0.7f}};
  const std::vector<SbVec3f> roof = {
      {0.2f, 0.9f, 1.12f}, {-0.2f, 0.9f, 1.12f}, {-0.22f, 0.0f, 1.14f}, {0.22f, 0.0f, 1.14f}};
  faces.loft(sill, roof);
  faces.add(roof);
  return faces.graph();
}
