#pragma once

#include "nodes/terrain/TeBlockGraph.h"
#include "nodes/terrain/TeStaticBlock.h"

#include <Inventor/fields/SoMFColor.h>
#include <Inventor/fields/SoMFFloat.h>
#include <Inventor/fields/SoMFString.h>
#include <Inventor/fields/SoSFBool.h>
#include <Inventor/fields/SoSFDouble.h>
#include <Inventor/fields/SoSFEnum.h>
#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/fields/SoSFVec2d.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/nodes/SoSubNode.h>

#include <memory>
#include <string>

/// A block of patches of generated terrain or elevation data, drawn around its own centre: x east, y north,
/// z up, metres. It is built when first needed and again after fields have changed; its scene graph of Coin's
/// own nodes is hidden, like that of SoFile. Fields that make no terrain give one warning through
/// SoDebugError, and nothing is drawn.
///
/// FILE FORMAT/DEFAULTS:
///
///     TeStaticTerrain {
///       seed           "0"
///       generator      "faults:profile=smooth"
///       filters        []
///       file           ""
///       verticalUnit   "auto"
///       fillVoids      FALSE
///       native         FALSE
///       blending       SMOOTH
///       samples        65
///       spacing        0
///       block          3
///       center         0 0
///       verticalScale  1
///       water          FALSE
///       waterLevel     0
///       colors         []
///       colorHeights   []
///       image          ""
///       parts          FALSE
///     }
class SoTeStaticTerrain : public SoNode {
  typedef SoNode inherited;
  SO_NODE_HEADER(SoTeStaticTerrain);

public:
  /// LINEAR: the document's weights; SMOOTH: those without creases (TeBlendProfile).
  enum Blending { LINEAR, SMOOTH };

  static void initClass();
  SoTeStaticTerrain();

  SoSFString seed;         ///< of the world: a whole number from 0 to 2^64 - 1
  SoSFString generator;    ///< specification (TeGeneratorRegistry)
  SoMFString filters;      ///< specifications, in order
  SoSFString file;         ///< elevation data instead of a generator; relative: beside the scene's file
  SoSFString verticalUnit; ///< of the file: "auto", "m", "0.1", "ft" … (teVerticalUnit)
  SoSFBool fillVoids;      ///< fills the file's voids from around them; else they are holes
  SoSFBool native;         ///< samples are the file's posts, the highest one in the world's origin
  SoSFEnum blending;       ///< of the maps from which patches are made; of no effect on a file
  SoSFInt32 samples;       ///< a side of a source map, odd
  SoSFDouble spacing;      ///< metres between samples; 0: the block covers the file; 1 without a file
  SoSFInt32 block;         ///< patches a side
  SoSFVec2d center;        ///< point of the world in the middle of the block, metres
  SoSFFloat verticalScale; ///< heights are drawn this many times as high
  SoSFBool water;          ///< draws a sheet of water
  SoSFFloat waterLevel;    ///< metres
  SoMFColor colors;        ///< grass, rock, snow; fewer: Terrane's own for the rest
  SoMFFloat colorHeights;  ///< metres where rock, and where snow begins; empty: from the range of heights
  SoSFString image;        ///< PNG file to be draped over the block; relative: beside the scene's file
  SoSFBool parts;          ///< patches, seams and corners in different colours

  /// The terrain, built if necessary; NULL if the fields make none. Valid until a field changes.
  const TeStaticBlock* getBlock();
  /// Its scene graph of Coin's own nodes; NULL likewise.
  SoSeparator* getGraph();
  /// Why there is no terrain; empty if there is.
  const std::string& getError();

  void doAction(SoAction* action) override;
  void callback(SoCallbackAction* action) override;
  void GLRender(SoGLRenderAction* action) override;
  void getBoundingBox(SoGetBoundingBoxAction* action) override;
  void getMatrix(SoGetMatrixAction* action) override;
  void pick(SoPickAction* action) override;
  void rayPick(SoRayPickAction* action) override;
  void search(SoSearchAction* action) override;
  void getPrimitiveCount(SoGetPrimitiveCountAction* action) override;
  SoChildList* getChildren() const override { return m_children.get(); }
  SbBool affectsState() const override { return FALSE; }
  void copyContents(const SoFieldContainer* from, SbBool copyConnections) override;
  void notify(SoNotList* list) override;

protected:
  ~SoTeStaticTerrain() override;
  SbBool readInstance(SoInput* input, unsigned short flags) override;

private:
  void update();
  TeStatus build();
  /// Moves `middle` to where a file's centre lies.
  TeResult<TeWorld> makeWorld(glm::dvec2& middle) const;
  TeResult<TeHeightSourcePtr> makeSource(double& metres, glm::dvec2& middle) const;
  TeResult<TeBlockStyle> makeStyle(const TeStaticBlock& block) const;

  std::unique_ptr<SoChildList> m_children; ///< one separator, or none
  std::unique_ptr<TeStaticBlock> m_block;
  std::string m_error;
  std::string m_folder; ///< of the file that the node was read from
  bool m_isCurrent = false;
};
