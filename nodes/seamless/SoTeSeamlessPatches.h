#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/seamless/TeSeamlessPictures.h"
#include "nodes/seamless/TeSeamlessViewers.h"

#include <Inventor/fields/SoMFColor.h>
#include <Inventor/fields/SoMFFloat.h>
#include <Inventor/fields/SoMFString.h>
#include <Inventor/fields/SoSFBool.h>
#include <Inventor/fields/SoSFColor.h>
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

/// One large terrain by Seamless Patches (Livny, Kogan and El-Sana 2007; docs/seamless-patches.md): square
/// patches of an implicit tree, chosen every frame by the view, whose sides fit without cracks. x east, y
/// north, z up, metres; drawn around `center` - `origin`.
///
/// Accuracy: `precision` is the document's factor p: a side of length l at distance d is fine enough where
/// p·l/d <= 1; from 1, below which it leaves cracks. `pixelError`, if more than 0, is used in its place: the
/// largest vertical deviation from the full resolution on the screen (deviation · focal length / distance).
/// It needs heights whose errors are known: a height map, or clipmaps beside which terrane-bake has written
/// them. The frame's true bound is in statistics(). A preceding SoComplexity lowers or raises the accuracy
/// 16^(value - 0.5) times, so 0.5, its default, changes nothing; p stays at least 1. Type BOUNDING_BOX draws
/// the box.
///
/// Seen by a camera, actions get the triangles that it draws with this camera; so what is behind it is not
/// there, except for rays, which meet everything. Without a camera the eye is as high above the middle as the
/// terrain is wide, and sees all of it on 1024 pixels.
///
/// Fields that make no terrain give one warning through SoDebugError; getError() tells what is wrong, and
/// nothing is drawn. Changing origin, center, size, accuracy or colours loads no heights again.
///
/// FILE FORMAT/DEFAULTS:
///
///     TeSeamlessPatches {
///       size                256 256 10
///       resolution          4096
///       minPatchResolution  16
///       levels              3
///       precision           2
///       pixelError          0
///       maxPatches          20000
///       geomorph            FALSE
///       instancing          TRUE
///       wholePatches        TRUE
///       wireframe           FALSE
///       heightSource        FLAT
///       heightFile          ""
///       verticalUnit        "auto"
///       heights             NULL
///       coloring            PLAIN
///       tileColor           1 1 1
///       stripColor          1 0 0
///       texture             ""
///       colors              NULL
///       mask                ""
///       detailTextures      []
///       detailRepeat        64
///       groundColors        []
///       groundHeights       []
///       groundSlopes        []
///       lodCamera           NULL
///       center              0 0 0
///       origin              0 0 0
///     }
class SoTeSeamlessPatches : public SoShape {
  typedef SoShape inherited;
  SO_NODE_HEADER(SoTeSeamlessPatches);

public:
  enum HeightSource {
    FLAT,      ///< all heights 0; then `precision` is used, as there is no error
    HEIGHTMAP, ///< heightFile, or setHeights()
    CLIPMAPS   ///< of the node in `heights`
  };

  enum Coloring {
    PLAIN,   ///< tileColor and stripColor
    TEXTURE, ///< `texture`, or `colors` if it is there
    DETAIL,  ///< four detailTextures mixed by `mask`
    HEIGHT   ///< by height and slope: pebbles, sand, grass, gravel, snow
  };

  static void initClass();
  SoTeSeamlessPatches();

  /// Extents in x and y, which are equal, and height of the largest 16 bit number (65535) of clipmaps and
  /// *.raw files. Extents 0: the height file's own, 1 m a sample if it has none.
  SoSFVec3f size;
  SoSFInt32 resolution;         ///< cells a side, a power of two; 0: that of the heights
  SoSFInt32 minPatchResolution; ///< lowest resolution of a patch, a power of two
  SoSFInt32 levels;             ///< resolutions of a patch, 2 .. 9; the highest is up to 512
  SoSFFloat precision;          ///< the document's factor, from 1
  SoSFFloat pixelError;         ///< pixels; 0: precision is used
  /// That are drawn in a frame, 1 .. 2^24; the accuracy is lowered to keep it, but with perspective not below
  /// precision 1.
  SoSFInt32 maxPatches;
  SoSFBool geomorph;   ///< resolutions change smoothly
  SoSFBool instancing; ///< a draw call for each list of equal shapes, not for each one
  /// Shapes are patches with one combination of resolutions, which makes few lists; FALSE: the document's
  /// tiles and strips, as is always so where these have colours of their own or combinations are too many.
  SoSFBool wholePatches;
  SoSFBool wireframe;
  SoSFEnum heightSource;
  SoSFString heightFile;   ///< TeSeamlessHeightFile; relative: beside the scene's file
  SoSFString verticalUnit; ///< of heightFile: "auto", "m", "0.1", "ft" … (teVerticalUnit)
  SoSFNode heights;        ///< TeClipmap
  SoSFEnum coloring;       ///< all colours are multiplied by the material's
  SoSFColor tileColor;
  SoSFColor stripColor;
  SoSFString texture;        ///< PNG over the whole terrain, north up; relative: beside the scene's file
  SoSFNode colors;           ///< TeClipmap of a colour pyramid, in place of texture
  SoSFString mask;           ///< PNG over the whole terrain: shares of the details in R, G, B and A
  SoMFString detailTextures; ///< four PNGs
  SoSFFloat detailRepeat;    ///< times that details are repeated along a side of the terrain
  SoMFColor groundColors;    ///< pebbles, sand, grass, gravel, snow; fewer: Terrane's own for the rest
  SoMFFloat groundHeights;   ///< four: metres where sand, grass, gravel and snow begin; none: by the range
  SoMFFloat groundSlopes;    ///< five: steepest slopes, metres a metre; none: Terrane's own

  SoSFNode lodCamera; ///< decides, under no transform, what is drawn how finely; NULL: the one that draws
  SoSFVec3d center;   ///< of the terrain, at height 0, in the world
  SoSFVec3d origin;   ///< point of the world drawn at the node's (0, 0, 0)

  /// Heights for heightSource HEIGHTMAP in place of heightFile; null: that again. (2^n+1)² samples, metres.
  void setHeights(std::shared_ptr<const TeHeightMap> map);
  /// Why there is no terrain; empty if there is. Loads it if necessary.
  const std::string& getError();
  /// Of the last frame drawn, in whichever context.
  const TeSeamlessStatistics& statistics() const { return m_viewers.statistics(); }

  /// Whether the last frame would have been finer, had its clipmaps been loaded; another one follows then.
  bool isLoading() const { return m_viewers.isWaiting(); }

  void GLRender(SoGLRenderAction* action) override;
  void rayPick(SoRayPickAction* action) override;
  void getPrimitiveCount(SoGetPrimitiveCountAction* action) override;
  void copyContents(const SoFieldContainer* from, SbBool copyConnections) override;
  void notify(SoNotList* list) override;

protected:
  ~SoTeSeamlessPatches() override;
  void generatePrimitives(SoAction* action) override;
  void computeBBox(SoAction* action, SbBox3f& box, SbVec3f& center) override;
  SbBool readInstance(SoInput* input, unsigned short flags) override;

private:
  /// Makes everything current that fields decide. False: there is no terrain.
  bool update();
  TeStatus build();
  TeResult<TeSeamlessContent> load();
  bool decidesHeights(const SoField* field) const;
  void pickTriangle(SoRayPickAction* action, const TeSeamlessPatch& patch,
                    const TeSeamlessSurface::Triangle& triangle);

  TeResult<TeSeamlessContent> m_content{TeSeamlessContent()};
  TeSeamlessViewers m_viewers;
  TeSeamlessPictures m_pictures;
  std::shared_ptr<const TeHeightMap> m_given; ///< by setHeights()
  SoOneShotSensor m_redraw;                   ///< while clipmaps are loaded
  std::string m_error;
  bool m_isReported = false; ///< by the node that has it
  std::string m_drawingError;
  std::string m_folder; ///< of the file that the node was read from
  bool m_isCurrent = false;
  bool m_isLoaded = false;
};
