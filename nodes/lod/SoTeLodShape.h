#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/fields/SoSFBool.h>
#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFNode.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/fields/SoSFVec3d.h>
#include <Inventor/fields/SoSFVec3f.h>
#include <Inventor/nodes/SoCamera.h>
#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoSubNode.h>
#include <Inventor/sensors/SoOneShotSensor.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <string>

/// What nodes that draw one square terrain as finely as a view needs it have in common. x east, y north, z
/// up, metres; drawn around `center` - `origin`. Abstract.
///
/// Seen by a camera, actions get the triangles that it draws with this camera; so what is behind it is not
/// there, except for rays, which meet the whole terrain. Without a camera the eye is as high above the middle
/// as the terrain is wide, and sees all of it on 1024 pixels. A SoComplexity of type BOUNDING_BOX draws the
/// box.
///
/// Fields that make no terrain give one warning through SoDebugError; getError() tells what is wrong, and
/// nothing is drawn.
class SoTeLodShape : public SoShape {
  typedef SoShape inherited;
  SO_NODE_ABSTRACT_HEADER(SoTeLodShape);

public:
  static void initClass();

  SoSFString heightFile;   ///< TeSeamlessHeightFile; relative: beside the scene's file
  SoSFString verticalUnit; ///< of heightFile: "auto", "m", "0.1", "ft" … (teVerticalUnit)
  /// Extents in x and y, which are equal, and height of the largest 16 bit number (65535) of *.raw files and
  /// clipmaps. Extents 0: the height file's own, 1 m a sample if it has none.
  SoSFVec3f size;
  /// Largest vertical deviation from the surface of all samples on the screen (deviation · focal length /
  /// distance), pixels, from 0; what 0 means, and the default, is the class's.
  SoSFFloat pixelError;
  SoSFBool geomorph; ///< vertices move smoothly where detail changes, if the method can
  SoSFBool wireframe;
  SoSFNode lodCamera; ///< decides, under no transform, what is drawn how finely; NULL: the one that draws
  SoSFVec3d center;   ///< of the terrain, at height 0, in the world
  SoSFVec3d origin;   ///< point of the world drawn at the node's (0, 0, 0)

  /// Heights in place of heightFile; null: that again. (2^n + 1)² samples, metres.
  void setHeights(std::shared_ptr<const TeHeightMap> map);
  /// Why there is no terrain; empty if there is. Loads it if necessary.
  const std::string& getError();

  void GLRender(SoGLRenderAction* action) override;
  void rayPick(SoRayPickAction* action) override;
  void getPrimitiveCount(SoGetPrimitiveCountAction* action) override;
  void copyContents(const SoFieldContainer* from, SbBool copyConnections) override;
  void notify(SoNotList* list) override;

protected:
  /// `usualPixelError`: the field's default.
  explicit SoTeLodShape(float usualPixelError);
  ~SoTeLodShape() override;

  /// Whether another value of a field of this node means other heights.
  virtual bool decidesHeights(const SoField* field) const;
  /// Gives up the heights that it has, and gets those that it should have. Sets `isReported`, which is false,
  /// if another node has warned of the error already.
  virtual TeStatus load(bool& isReported) = 0;
  /// Makes current what fields say beside the heights, which are there. `isReported`: likewise.
  virtual TeStatus build(bool& isReported) = 0;

  // Asked of a terrain only: after load() and build() without an error.
  virtual SbBox3f bounds() const = 0;
  virtual std::int64_t triangles(SoAction* action) = 0;
  /// Draws after sendMaterial(). Error, told of once as long as it stays the same: OpenGL cannot draw it …
  virtual TeStatus draw(SoGLRenderAction* action) = 0;
  /// Whether another frame would be finer than the one just drawn.
  virtual bool wantsFrame() const = 0;
  /// The box is met; the action's ray is in the coordinates of the node.
  virtual void pickTriangles(SoRayPickAction* action) = 0;
  /// By beginShape(), shapeVertex() and endShape().
  virtual void emitTriangles(SoAction* action) = 0;

  /// Sends the state's material and light to OpenGL, and that triangles are counter-clockwise, whatever hints
  /// a neighbour needs.
  static void sendMaterial(SoGLRenderAction* action);
  /// They are loaded again when they are needed next.
  void forgetHeights();
  const std::shared_ptr<const TeHeightMap>& givenHeights() const { return m_given; } ///< by setHeights()
  /// Path of heightFile. Error: none is named.
  TeResult<std::string> heightPath() const;
  /// Of the scene's file that the node was read from; empty: not known.
  const std::string& folder() const { return m_folder; }
  /// The camera in lodCamera; null if there is none. Error: another node.
  TeResult<TeNodePtr<SoCamera>> readLodCamera() const;
  /// Of the terrain, in the coordinates of the node; not finite if a field is not.
  glm::dvec3 middle() const;

  void generatePrimitives(SoAction* action) override;
  void computeBBox(SoAction* action, SbBox3f& box, SbVec3f& center) override;
  SbBool readInstance(SoInput* input, unsigned short flags) override;

private:
  /// Makes everything current that fields decide. False: there is no terrain.
  bool update();

  std::shared_ptr<const TeHeightMap> m_given;
  TeStatus m_loaded;
  SoOneShotSensor m_redraw;
  std::string m_error;
  std::string m_drawingError;
  std::string m_folder;
  bool m_isCurrent = false;
  bool m_isLoaded = false;
};
