#pragma once

#include "nodes/lod/SoTeLodShape.h"
#include "nodes/seamless/TeSeamlessPictures.h"
#include "nodes/seamless/TeSeamlessViewers.h"

#include <Inventor/fields/SoMFColor.h>
#include <Inventor/fields/SoMFFloat.h>
#include <Inventor/fields/SoMFString.h>
#include <Inventor/fields/SoSFColor.h>
#include <Inventor/fields/SoSFEnum.h>
#include <Inventor/fields/SoSFInt32.h>

/// One large terrain by Seamless Patches (Livny, Kogan and El-Sana 2007; docs/seamless-patches.md): square
/// patches of an implicit tree, chosen every frame by the view, whose sides fit without cracks.
///
/// Accuracy: `precision` is the document's factor p: a side of length l at distance d is fine enough where
/// p·l/d <= 1; from 1, below which it leaves cracks. `pixelError`, if more than 0, is used in its place.
/// It needs heights whose errors are known: a height map, or clipmaps beside which terrane-bake has written
/// them. The frame's true bound is in statistics(). A preceding SoComplexity lowers or raises the accuracy
/// 16^(value - 0.5) times, so 0.5, its default, changes nothing; p stays at least 1.
///
/// Changing origin, center, size, accuracy or colours loads no heights again.
///
/// FILE FORMAT/DEFAULTS:
///
///     TeSeamlessPatches {
///       heightFile          ""
///       verticalUnit        "auto"
///       size                256 256 10
///       pixelError          0
///       geomorph            FALSE
///       wireframe           FALSE
///       lodCamera           NULL
///       center              0 0 0
///       origin              0 0 0
///       resolution          4096
///       minPatchResolution  16
///       levels              3
///       precision           2
///       maxPatches          20000
///       instancing          TRUE
///       wholePatches        TRUE
///       heightSource        FLAT
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
///     }
class SoTeSeamlessPatches : public SoTeLodShape {
  typedef SoTeLodShape inherited;
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

  SoSFInt32 resolution;         ///< cells a side, a power of two; 0: that of the heights
  SoSFInt32 minPatchResolution; ///< lowest resolution of a patch, a power of two
  SoSFInt32 levels;             ///< resolutions of a patch, 2 .. 9; the highest is up to 512
  SoSFFloat precision;          ///< the document's factor, from 1
  /// That are drawn in a frame, 1 .. 2^24; the accuracy is lowered to keep it, but with perspective not below
  /// precision 1.
  SoSFInt32 maxPatches;
  SoSFBool instancing; ///< a draw call for each list of equal shapes, not for each one
  /// Shapes are patches with one combination of resolutions, which makes few lists; FALSE: the document's
  /// tiles and strips, as is always so where these have colours of their own or combinations are too many.
  SoSFBool wholePatches;
  SoSFEnum heightSource;
  SoSFNode heights;  ///< TeClipmap
  SoSFEnum coloring; ///< all colours are multiplied by the material's
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

  /// Of the last frame drawn, in whichever context.
  const TeSeamlessStatistics& statistics() const { return m_viewers.statistics(); }

  /// Whether the last frame would have been finer, had its clipmaps been loaded; another one follows then.
  bool isLoading() const { return m_viewers.isWaiting(); }

protected:
  ~SoTeSeamlessPatches() override;
  bool decidesHeights(const SoField* field) const override;
  TeStatus load(bool& isReported) override;
  TeStatus build(bool& isReported) override;
  SbBox3f bounds() const override { return m_viewers.box(); }
  std::int64_t triangles(SoAction* action) override { return m_viewers.triangles(action); }
  TeStatus draw(SoGLRenderAction* action) override;
  bool wantsFrame() const override { return m_viewers.isWaiting(); }
  void pickTriangles(SoRayPickAction* action) override;
  void emitTriangles(SoAction* action) override;

private:
  TeResult<TeSeamlessContent> readContent(bool& isReported) const;
  void pickTriangle(SoRayPickAction* action, const TeSeamlessPatch& patch,
                    const TeSeamlessSurface::Triangle& triangle);

  TeSeamlessContent m_content;
  TeSeamlessViewers m_viewers;
  TeSeamlessPictures m_pictures;
};
