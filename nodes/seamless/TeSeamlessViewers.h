#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/seamless/TeSeamlessChoice.h"
#include "nodes/seamless/TeSeamlessContent.h"
#include "nodes/seamless/TeSeamlessDrawing.h"
#include "nodes/seamless/TeSeamlessStatistics.h"
#include "nodes/seamless/TeSeamlessSurface.h"

#include <Inventor/nodes/SoCamera.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>

class SbLine;
class SoGLRenderAction;
class SoState;

/// What a terrain is to whoever looks at it, in any number of OpenGL contexts and for actions that draw
/// nothing: chooses for each what there is to see, and draws it. For the thread that makes all Coin calls.
class TeSeamlessViewers {
public:
  /// Of Seamless Patches, ready to be seen.
  struct Scene {
    TeSeamlessContent content;
    TeSeamlessPlacement placement;
    TeSeamlessAccuracy accuracy; ///< before SoComplexity
    TeSeamlessLook look;
    TeNodePtr<SoCamera> lodCamera; ///< null: the one that draws
  };

  /// Contexts keep what they have of a terrain that is the same as before.
  void setScene(Scene scene);
  /// There is nothing to see.
  void clear();
  const Scene& scene() const { return m_scene; }
  SbBox3f box() const;

  /// Draws in the action's context, with the state's matrices. Error: OpenGL cannot draw it.
  TeStatus draw(SoGLRenderAction* action);
  const TeSeamlessStatistics& statistics() const { return m_statistics; }

  /// What a frame with the state's camera draws, or did if the last one was seen the same way; nothing if
  /// the camera sees nothing. With a line: the patches along it, as finely as they are drawn, in view or not.
  TeSeamlessSelection selected(SoState* state, const SbLine* along = nullptr) const;
  using PatchVisitor = std::function<void(const TeSeamlessPatch&, TeSeamlessSurface&)>;
  void forEachPatch(const TeSeamlessSelection& selection, const PatchVisitor& visit) const;

private:
  std::optional<TeLodView> view(SoState* state) const;
  /// Where there is no camera.
  TeLodView defaultView() const;
  TeSeamlessAccuracy accuracy(SoState* state) const;
  void count(const TeSeamlessChoice& choice, bool isNew, const TeSeamlessCounts& drawn);

  Scene m_scene;
  std::unique_ptr<TeSeamlessDrawing> m_drawing;
  std::map<std::uint32_t, TeSeamlessChoice> m_choices; ///< by context
  std::uint32_t m_lastContext = 0;
  TeSeamlessStatistics m_statistics;
};
