#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/TePicture.h"
#include "nodes/TeSurfaceColours.h"
#include "nodes/TeWorldRect.h"
#include "patchdb/TePatchMesh.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoMaterialBinding.h>
#include <Inventor/nodes/SoNormalBinding.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoTexture2.h>
#include <Inventor/nodes/SoTextureCoordinateBinding.h>
#include <Inventor/nodes/SoTranslation.h>

#include <glm/vec2.hpp>

#include <array>

/// Makes scene graphs of pieces of the surface from Coin's own nodes alone, so that any Inventor program can
/// draw, pick and write them.
///
/// All pieces of one builder have coordinates relative to one point of the world, the *anchor*, and share one
/// translation from the scene's origin to it. A vertex that two pieces share is therefore the same bits under
/// the same transformation in both, and no pixel shows between them. Choose the anchor near the pieces:
/// coordinates are float, so a vertex d metres away from it is placed to about d·6e-8 metres.
///
/// A piece costs its mesh's bytes plus 4 a vertex for the colour (8 for texture coordinates if an image is
/// draped), and is independent of the mesh afterwards.
class TePatchGraphBuilder {
public:
  explicit TePatchGraphBuilder(glm::dvec2 anchor);

  glm::dvec2 anchor() const { return m_anchor; }
  /// The point of the world that is the scene's (0, 0, 0); the anchor at first. Moves pieces made before,
  /// too.
  void setWorldOrigin(glm::dvec3 origin);
  /// Colours by height and slope for pieces made from now on; limited to 0 .. 1.
  void setColours(const TeSurfaceColours& colours) { m_colours = colours; }
  /// Patches, seams and corners each in one colour of their own instead.
  void setShowParts(bool show) { m_showParts = show; }
  /// Drapes an image over the rectangle, its first row on the rectangle's south side, instead of colours;
  /// what lies outside shows the image's rim. Error: an empty image or rectangle.
  TeStatus setImage(const TePicture& image, const TeWorldRect& rect);

  /// The scene graph of a piece; without a shape if the mesh has no triangles.
  TeNodePtr<SoSeparator> build(const TePatchMesh& mesh) const;
  /// A level sheet of water at a height.
  TeNodePtr<SoSeparator> water(const TeWorldRect& rect, float height) const;

private:
  void addColours(SoSeparator& piece, const TePatchMesh& mesh) const;
  void addTextureCoordinates(SoSeparator& piece, const TePatchMesh& mesh) const;

  glm::dvec2 m_anchor;
  TeSurfaceColours m_colours;
  bool m_showParts = false;
  TeWorldRect m_imageRect;
  // Nodes that all pieces share.
  TeNodePtr<SoTranslation> m_translation;
  TeNodePtr<SoShapeHints> m_hints;
  TeNodePtr<SoNormalBinding> m_normalBinding;
  TeNodePtr<SoMaterialBinding> m_materialBinding;
  TeNodePtr<SoTextureCoordinateBinding> m_textureBinding;
  TeNodePtr<SoTexture2> m_image;
  std::array<TeNodePtr<SoBaseColor>, 3> m_partColours;
};
