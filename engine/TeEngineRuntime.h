#pragma once

#include "engine/TeEngineSettings.h"
#include "engine/TeStatistics.h"
#include "engine/camera/TeCameraRig.h"
#include "engine/hud/TeHud.h"
#include "engine/input/TeKeyState.h"
#include "engine/objects/TeObjectScene.h"
#include "engine/objects/TeObjects.h"
#include "engine/terrain/TeTerrain.h"

#include <deque>
#include <memory>
#include <vector>

/// What exists of an engine from initialize() on: its terrain, its part of the scene, its camera and HUD, and
/// the turn of the loop that joins them. TeEngine is its public face and keeps what it refers to alive.
class TeEngineRuntime {
public:
  TeEngineRuntime(TeEngineSettings& settings, TePatchDatabase& database, TeObjects& objects, TeCameraRig& rig,
                  TeHud& hud, TeTerrain::Held held);
  ~TeEngineRuntime(); ///< takes the engine's nodes out of the scene
  TeEngineRuntime(const TeEngineRuntime&) = delete;
  TeEngineRuntime& operator=(const TeEngineRuntime&) = delete;

  /// Builds the patches below all objects and fills the scene. Error: that of the active one cannot be built.
  TeStatus start();
  /// Error, and nothing done: dt is negative or not finite, or a call-back within a tick calls it.
  TeStatus tick(double dt);
  /// Nothing is done if an object's update or a job's step calls it.
  void finishJobs();
  void frameDrawn(double frameSeconds, double drawSeconds, double finishSeconds);

  void addObject(TeObject& object);
  /// Before the object is deleted.
  void removeObject(const TeObject& object);
  void setRadius(int radius);
  /// Takes the wanted error over from the settings.
  void updatePixelError();
  void setWireframe(bool wireframe);
  bool isWireframe() const { return m_wireframe; }
  void setPaused(bool paused) { m_paused = paused; }
  bool isPaused() const { return m_paused; }
  void postKey(const TeKeyEvent& event) { m_keys.push_back(event); }
  void addJob(std::unique_ptr<TeJob> job) { m_queue.add(std::move(job)); }
  void setColours(const TeSurfaceColours& colours) { m_terrain.setColours(colours); }

  bool isIdle() const;
  bool isMoving() const;
  bool needsRedraw() const { return m_changed; }
  const TeStatistics& statistics() const { return m_statistics; }
  std::uint64_t terrainHash() const { return m_terrain.hash(); }

private:
  void closeTick();
  void steerQuality(double frameSeconds, double drawSeconds, double finishSeconds);
  void handleKeys();
  void handleKey(const TeKeyEvent& event);
  void simulate(double dt);
  void placeObjects();
  void followObject(double dt);
  void work(TeAllowance& allowance);
  TeAllowance allowance() const;
  void countSlice(const TeAllowance& slice);
  void updateCamera();
  void updateHud();
  void updateStatistics();
  void countFrame();
  void callBack();

  TeEngineSettings& m_settings;
  TePatchDatabase& m_database;
  TeObjects& m_objects;
  TeCameraRig& m_rig;
  TeHud& m_hud;
  TeMapMaker m_maps;
  TeJobQueue m_queue;
  TeTerrainScene m_scene;
  TeTerrain m_terrain;
  TeObjectScene m_objectScene;
  TeStatistics m_statistics;
  std::vector<TeKeyEvent> m_keys;
  TeKeyState m_pressed;
  std::deque<TeTerrain::Event> m_events; ///< that call-backs were not told of yet
  bool m_paused = false;
  bool m_wireframe = false;
  bool m_changed = true;
  bool m_errorChanged = false; ///< by the quality goal, since the last tick
  double m_after = 0;          ///< seconds that ticks take after their slice, lately
  double m_longestUnit = 0;    ///< seconds, of the last tick
  bool m_wasComplete = false;  ///< the block, since the start or the last jump
  bool m_ticking = false;
  bool m_inside = false;   ///< of an object's update or a job's step
  bool m_tickOpen = false; ///< the uploads that the last tick led to are not counted yet
  int m_hudChanges = 0;
  double m_hudTime = 0; ///< simulated, of the last change of its numbers
  bool m_hudIsOld = true;
  std::uint64_t m_viewHash = 0; ///< of what the camera was last set to
};
