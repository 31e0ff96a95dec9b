#pragma once

#include "engine/budget/TeFrameBudget.h"
#include "engine/input/TeKeyEvent.h"
#include "engine/quality/TeQuality.h"
#include "nodes/TeNodePtr.h"
#include "nodes/TeSurfaceColours.h"
#include "patchdb/TePatchKey.h"

#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include <functional>
#include <optional>
#include <string>

class TeObject;

/// What a program has told a TeEngine about its endless terrain.
struct TeEngineSettings {
  using PatchCallback = std::function<void(const TePatchKey& key, SoGroup* graph)>;
  using ErrorCallback = std::function<void(const std::string& message)>;
  using CollisionHook = std::function<void(double dt)>;
  using KeyCallback = std::function<bool(const TeKeyEvent& event)>;

  TeNodePtr<SoSeparator> sceneRoot;
  TeNodePtr<SoPerspectiveCamera> sceneCamera;
  TeNodePtr<SoSeparator> hudRoot;
  TeNodePtr<SoOrthographicCamera> hudCamera;
  TeObject* active = nullptr;
  std::optional<TeSurfaceColours> colours;
  int radius = 1;
  TeFrameBudget budget;
  int unitBudget = 0;     ///< work units a tick; 0 = time
  double pixelError = 0;  ///< as long as no quality goal is set
  double qualityRate = 0; ///< frames a second; 0 = no goal
  TeQuality quality;
  int workers = 0;
  PatchCallback patchReady;
  PatchCallback patchDropped;
  ErrorCallback error;
  CollisionHook collisions;
  KeyCallback key;
};
