#pragma once

#include "nodes/seamless/TeSeamlessDrawing.h"
#include "nodes/seamless/TeSeamlessScene.h"
#include "nodes/seamless/TeSeamlessStatistics.h"
#include "nodes/seamless/TeSeamlessSurface.h"
#include "nodes/seamless/TeSeamlessViewer.h"

#include <cstdint>
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
/// nothing: chooses for each what there is to see, and draws it. The places in a scene where the same node
/// stands are viewers of their own. For the thread that makes all Coin calls.
class TeSeamlessViewers {
public:
  /// Of those that have not looked for longest, some are forgotten.
  static constexpr std::size_t kMostViewers = 16;

  TeSeamlessViewers();
  ~TeSeamlessViewers();
  TeSeamlessViewers(const TeSeamlessViewers&) = delete;
  TeSeamlessViewers& operator=(const TeSeamlessViewers&) = delete;

  /// Viewers keep what they have of heights that are the same as before.
  void setScene(TeSeamlessScene scene);
  /// There is nothing to see.
  void clear();
  const TeSeamlessScene& scene() const { return m_scene; }
  SbBox3f box() const;

  /// Draws in the action's context, with the state's matrices. Error: OpenGL cannot draw it, or a clipmap
  /// cannot be read.
  TeStatus draw(SoGLRenderAction* action);
  /// Whether the last draw() would have drawn more, had its clipmaps been there.
  bool isWaiting() const { return m_isWaiting; }
  const TeSeamlessStatistics& statistics() const { return m_statistics; }

  using PatchVisitor = std::function<void(const TeSeamlessPatch&, TeSeamlessSurface&)>;
  /// What a frame with the camera of an action's state draws, or did if the last one was seen the same way;
  /// nothing if the camera sees nothing. With a line: the patches along it, as finely as they are drawn, in
  /// view or not.
  void forEachPatch(SoAction* action, const SbLine* along, const PatchVisitor& visit);
  std::int64_t triangles(SoAction* action);

private:
  using Key = std::pair<std::uint32_t, std::uint64_t>; ///< context, place in the scene

  static void onContextDestroyed(std::uint32_t context, void* viewers);
  TeSeamlessViewer& viewer(const Key& key);
  /// The one whose picture an action means.
  TeSeamlessViewer* lastViewer(SoAction* action);
  TeSeamlessViewer* select(SoAction* action, const SbLine* along, TeSeamlessSelection& selection);
  void releaseAll();

  std::optional<TeLodView> view(SoState* state) const;
  TeSeamlessAccuracy accuracy(SoState* state) const;
  void count(const TeSeamlessViewer& viewer, const TeSeamlessCounts& drawn);

  TeSeamlessScene m_scene;
  std::shared_ptr<const TeSeamlessParts> m_parts; ///< that are drawn
  std::unique_ptr<TeSeamlessDrawing> m_drawing;
  std::map<Key, TeSeamlessViewer> m_viewers;
  TeSeamlessViewer m_unseen; ///< of actions before anything was drawn
  std::uint64_t m_uses = 0;
  bool m_isWaiting = false;
  TeSeamlessStatistics m_statistics;
};
