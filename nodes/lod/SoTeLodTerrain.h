#pragma once

#include "nodes/lod/SoTeLodShape.h"
#include "nodes/lod/TeSquareExtent.h"
#include "nodes/lod/drawing/TeLodViewers.h"

#include <Inventor/fields/SoSFEnum.h>
#include <Inventor/fields/SoSFInt32.h>

/// A square terrain drawn by any of the LOD methods (TeLodMethods; docs/lod-terrain.md), to compare them and
/// the ways in which triangles come to OpenGL. (TeSeamlessPatches draws its method with less, as heights lie
/// on the GPU there.)
///
/// Accuracy: `pixelError`, 0 for every sample in view, or `dial`, what the method's document turns. A
/// preceding SoComplexity makes either 16^(value - 0.5) times as accurate: 0.5, its default, changes nothing.
/// The frame's true bound is in statistics().
///
/// It is drawn with the lights, material, fog, clip planes, draw styles and shaders of the scene around it,
/// but without its textures. Normals are those of all samples, however coarse the triangles.
///
/// Rays meet the triangles that are drawn, and where none are the surface of all samples. Changing all but
/// method, heights and size makes nothing anew.
///
/// FILE FORMAT/DEFAULTS:
///
///     TeLodTerrain {
///       heightFile    ""
///       verticalUnit  "auto"
///       size          256 256 10
///       pixelError    1
///       geomorph      FALSE
///       wireframe     FALSE
///       lodCamera     NULL
///       center        0 0 0
///       origin        0 0 0
///       method        "seamless"
///       dial          0
///       maxTriangles  4194304
///       slice         0
///       submission    VBO_STATIC
///       coloring      PLAIN
///     }
class SoTeLodTerrain : public SoTeLodShape {
  typedef SoTeLodShape inherited;
  SO_NODE_HEADER(SoTeLodTerrain);

public:
  enum Submission { ///< TeLodSubmission
    IMMEDIATE,
    VERTEX_ARRAYS,
    INDEXED_ARRAYS,
    VBO_STATIC,
    VBO_DYNAMIC,
    VBO_STREAM,
    DISPLAY_LISTS
  };

  enum Coloring {
    PLAIN, ///< the material's
    HEIGHT ///< by height and slope, in place of its diffuse colour: pebbles, sand, grass, gravel, snow
  };

  static void initClass();
  SoTeLodTerrain();

  SoSFString method;      ///< one of TeLodMethods::names()
  SoSFFloat dial;         ///< the method's own, if more than 0: used in place of pixelError
  SoSFInt32 maxTriangles; ///< from 1; the accuracy is lowered to keep it
  /// Seconds of CPU time for choosing triangles in a frame, of methods that can go on in the next one; 0: as
  /// long as it takes. A frame is asked for until all is chosen.
  SoSFFloat slice;
  SoSFEnum submission;
  SoSFEnum coloring;

  /// Terrain in place of heights, size and center; null: those again.
  void setField(TeLodFieldPtr field);
  /// Of the last frame drawn, in whichever context.
  const TeLodStatistics& statistics() const { return m_viewers.statistics(); }

  void copyContents(const SoFieldContainer* from, SbBool copyConnections) override;

protected:
  ~SoTeLodTerrain() override;
  TeStatus load(bool& isReported) override;
  TeStatus build(bool& isReported) override;
  SbBox3f bounds() const override { return m_viewers.box(); }
  std::int64_t triangles(SoAction* action) override { return m_viewers.triangles(action); }
  TeStatus draw(SoGLRenderAction* action) override;
  bool wantsFrame() const override { return !m_viewers.statistics().isComplete; }
  void pickTriangles(SoRayPickAction* action) override;
  void emitTriangles(SoAction* action) override;

private:
  TeStatus place(TeLodScene& scene);
  TeStatus readAccuracy(TeLodScene& scene) const;
  TeStatus readLook(TeLodScene& scene) const;
  /// Makes some colours those of the state. False if they are not to be used.
  bool setColours(SoState* state, const std::vector<std::uint32_t>& colours);

  TeLodFieldPtr m_givenField; ///< by setField()
  std::shared_ptr<const TeHeightMap> m_map;
  TeSquareExtent m_extent; ///< of m_map
  TeLodFieldPtr m_field;   ///< of m_map, corner at 0
  TeLodViewers m_viewers;
};
