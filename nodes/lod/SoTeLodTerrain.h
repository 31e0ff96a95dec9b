#pragma once

#include "nodes/lod/TeSquareExtent.h"
#include "nodes/lod/drawing/TeLodViewers.h"

#include <Inventor/fields/SoSFBool.h>
#include <Inventor/fields/SoSFEnum.h>
#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/fields/SoSFNode.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/fields/SoSFVec3d.h>
#include <Inventor/fields/SoSFVec3f.h>
#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoSubNode.h>
#include <Inventor/sensors/SoOneShotSensor.h>

#include <memory>
#include <string>

/// A square terrain drawn by any of the LOD methods (TeLodMethods; docs/lod-terrain.md), to compare them and
/// the ways in which triangles come to OpenGL. x east, y north, z up, metres; drawn around `center` -
/// `origin`. (TeSeamlessPatches draws its method with less, as heights lie on the GPU there.)
///
/// Accuracy: `pixelError`, the largest vertical deviation from the surface of all samples on the screen
/// (deviation · focal length / distance), or `dial`, what the method's document turns. A preceding
/// SoComplexity makes either 16^(value - 0.5) times as accurate: 0.5, its default, changes nothing. Type
/// BOUNDING_BOX draws the box. The frame's true bound is in statistics().
///
/// It is drawn with the lights, material, fog, clip planes, draw styles and shaders of the scene around it,
/// but without its textures. Normals are those of all samples, however coarse the triangles.
///
/// Seen by a camera, actions get the triangles that it draws with this camera; so what is behind it is not
/// there, except for rays, which meet the surface of all samples where nothing is drawn. Without a camera
/// the eye is as high above the middle as the terrain is wide, and sees all of it on 1024 pixels.
///
/// Fields that make no terrain give one warning through SoDebugError; getError() tells what is wrong, and
/// nothing is drawn. Changing all but method, heights and size makes nothing anew.
///
/// FILE FORMAT/DEFAULTS:
///
///     TeLodTerrain {
///       method        "seamless"
///       heightFile    ""
///       verticalUnit  "auto"
///       size          256 256 10
///       pixelError    1
///       dial          0
///       geomorph      FALSE
///       maxTriangles  4194304
///       slice         0
///       submission    VBO_STATIC
///       wireframe     FALSE
///       coloring      PLAIN
///       lodCamera     NULL
///       center        0 0 0
///       origin        0 0 0
///     }
class SoTeLodTerrain : public SoShape {
  typedef SoShape inherited;
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

  SoSFString method;       ///< one of TeLodMethods::names()
  SoSFString heightFile;   ///< TeSeamlessHeightFile; relative: beside the scene's file
  SoSFString verticalUnit; ///< of heightFile: "auto", "m", "0.1", "ft" … (teVerticalUnit)
  /// Extents in x and y, which are equal, and height of the largest 16 bit number (65535) of *.raw files.
  /// Extents 0: the height file's own, 1 m a sample if it has none.
  SoSFVec3f size;
  SoSFFloat pixelError;   ///< pixels; 0: every sample in view
  SoSFFloat dial;         ///< the method's own, if more than 0: used in place of pixelError
  SoSFBool geomorph;      ///< vertices move smoothly, if the method can
  SoSFInt32 maxTriangles; ///< from 1; the accuracy is lowered to keep it
  /// Seconds of CPU time for choosing triangles in a frame, of methods that can go on in the next one; 0: as
  /// long as it takes. A frame is asked for until all is chosen.
  SoSFFloat slice;
  SoSFEnum submission;
  SoSFBool wireframe;
  SoSFEnum coloring;
  SoSFNode lodCamera; ///< decides, under no transform, what is drawn how finely; NULL: the one that draws
  SoSFVec3d center;   ///< of the terrain, at height 0, in the world
  SoSFVec3d origin;   ///< point of the world drawn at the node's (0, 0, 0)

  /// Heights in place of heightFile; null: that again. (2^n + 1)² samples, metres.
  void setHeights(std::shared_ptr<const TeHeightMap> map);
  /// Terrain in place of heights, size and center; null: those again.
  void setField(TeLodFieldPtr field);
  /// Why there is no terrain; empty if there is. Loads it if necessary.
  const std::string& getError();
  /// Of the last frame drawn, in whichever context.
  const TeLodStatistics& statistics() const { return m_viewers.statistics(); }

  void GLRender(SoGLRenderAction* action) override;
  void rayPick(SoRayPickAction* action) override;
  void getPrimitiveCount(SoGetPrimitiveCountAction* action) override;
  void copyContents(const SoFieldContainer* from, SbBool copyConnections) override;
  void notify(SoNotList* list) override;

protected:
  ~SoTeLodTerrain() override;
  void generatePrimitives(SoAction* action) override;
  void computeBBox(SoAction* action, SbBox3f& box, SbVec3f& center) override;
  SbBool readInstance(SoInput* input, unsigned short flags) override;

private:
  /// Makes everything current that fields decide. False: there is no terrain.
  bool update();
  TeStatus build();
  TeStatus load();
  TeStatus place(TeLodScene& scene);
  TeStatus readAccuracy(TeLodScene& scene) const;
  TeStatus readLook(TeLodScene& scene) const;
  void forgetHeights();
  /// Makes some colours those of the state. False if they are not to be used.
  bool setColours(SoState* state, const std::vector<std::uint32_t>& colours);

  std::shared_ptr<const TeHeightMap> m_given; ///< by setHeights()
  TeLodFieldPtr m_givenField;                 ///< by setField()
  std::shared_ptr<const TeHeightMap> m_map;
  TeSquareExtent m_extent; ///< of m_map
  TeLodFieldPtr m_field;   ///< of m_map, corner at 0
  TeStatus m_loaded;
  TeLodViewers m_viewers;
  SoOneShotSensor m_redraw; ///< while a selection goes on
  std::string m_error;
  std::string m_drawingError;
  std::string m_folder; ///< of the file that the node was read from
  bool m_isCurrent = false;
  bool m_isLoaded = false;
};
