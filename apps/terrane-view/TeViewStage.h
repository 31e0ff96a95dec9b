#pragma once

#include "apps/common/TeCommonOptions.h"
#include "apps/terrane-view/TeFrustumLines.h"
#include "apps/terrane-view/TeViewContent.h"
#include "engine/hud/TeHud.h"

#include <Inventor/SbColor.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

/// What is drawn: sky if asked for, camera, sun, the content, the first camera's frustum, and text over it.
class TeViewStage {
public:
  /// The content outlives it.
  TeViewStage(const TeViewContent& content, const TeViewOptions& options, const TeCommonOptions& common);

  SoSeparator& all() { return *m_all; }
  SoSeparator& scene() { return *m_scene; }
  const SbColor& background() const { return m_background; }
  TeHud& hud() { return m_hud; }
  /// The user's camera while the second one draws: it decides about detail.
  SoPerspectiveCamera* lodCamera() const { return m_lodCamera.get(); }

  /// Of the picture, pixels.
  void setSize(int width, int height);
  /// Lines in place of the content's surfaces.
  void setWireframe(bool on);
  /// Where the user is, and whether that is seen from a second camera, above and behind.
  void show(const TeViewPose& pose, bool secondCamera);
  /// A camera from where all is seen, from the south and above.
  static TeViewPose overview(const TeViewContent& content);

private:
  void createScene(const TeViewOptions& options);
  void setPlanes(SoPerspectiveCamera& camera, const TeViewPose& pose) const;
  TeViewPose secondPose(const TeViewPose& first) const;

  const TeViewContent& m_content;
  SbColor m_background{0.62f, 0.75f, 0.88f};
  TeNodePtr<SoSeparator> m_all;
  TeNodePtr<SoSeparator> m_scene;
  TeNodePtr<SoSeparator> m_hudRoot;
  TeNodePtr<SoPerspectiveCamera> m_camera; ///< the one that draws
  TeNodePtr<SoPerspectiveCamera> m_lodCamera;
  TeNodePtr<SoDrawStyle> m_style;
  TeFrustumLines m_frustum;
  TeHud m_hud;
  int m_width = 1;
  int m_height = 1;
};
