#pragma once

#include "nodes/lod/drawing/TeLodScene.h"
#include "nodes/lod/drawing/TeLodStatistics.h"
#include "nodes/lod/drawing/TeLodViewer.h"

#include <Inventor/SbBox3f.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

class SbLine;
class SoAction;
class SoGLRenderAction;
class SoState;

/// What a terrain is to whoever looks at it, in any number of OpenGL contexts and for actions that draw
/// nothing. The places in a scene where the same node stands are viewers of their own, each with a method of
/// its own, as these may keep their mesh from frame to frame. For the thread that makes all Coin calls.
class TeLodViewers {
public:
  /// Of those that have not looked for longest, some are forgotten.
  static constexpr std::size_t kMostViewers = 8;

  TeLodViewers();
  ~TeLodViewers();
  TeLodViewers(const TeLodViewers&) = delete;
  TeLodViewers& operator=(const TeLodViewers&) = delete;

  /// Viewers keep what they have if method and field are the same as before. Error: no such method, or one
  /// that cannot have the field; there is nothing to see then.
  TeStatus setScene(TeLodScene scene);
  /// There is nothing to see.
  void clear();
  const TeLodScene& scene() const { return m_scene; }
  SbBox3f box() const;

  /// Draws in the action's context, with the state's matrices; in the scene's colours or the material's.
  /// Error: OpenGL cannot draw it.
  TeStatus draw(SoGLRenderAction* action, bool withColours);
  const TeLodStatistics& statistics() const { return m_statistics; }

  using MeshVisitor = std::function<void(const TeLodMesh& part)>;
  /// What a frame with the camera of an action's state draws, or did if the last one was seen the same way,
  /// part by part; nothing if the camera sees nothing.
  void forEachPart(SoAction* action, const MeshVisitor& visit);
  std::int64_t triangles(SoAction* action);
  /// The surface of all samples along a line, in view or not.
  void forEachPartAlong(const SbLine& line, const MeshVisitor& visit);
  /// The view for which forEachPart() gives what is drawn, in the node's coordinates.
  std::optional<TeLodView> view(SoState* state) const;

private:
  using Key = std::pair<std::uint32_t, std::uint64_t>; ///< context, place in the scene

  static void onContextDestroyed(std::uint32_t context, void* viewers);
  void releaseAll();
  std::unique_ptr<TeLodMethod> makeMethod();
  TeLodViewer& viewer(const Key& key);
  /// One that has chosen what the action's camera sees; null if that is nothing.
  const TeLodViewer* chosen(SoAction* action);
  std::optional<TeLodView> fieldView(SoState* state) const;
  TeLodAccuracy accuracy(SoState* state) const;
  void count(const TeLodViewer& viewer, const TeLodRenderer::Counts& drawn);

  TeLodScene m_scene;
  std::unique_ptr<TeLodMethod> m_spare; ///< for the first viewer
  std::map<Key, TeLodViewer> m_viewers;
  std::unique_ptr<TeLodViewer> m_unseen;     ///< of actions that see what no viewer has drawn
  std::unique_ptr<TeLodMethod> m_allSamples; ///< of rays
  TeLodDial m_dial;
  std::uint64_t m_uses = 0;
  TeLodStatistics m_statistics;
};
