#pragma once

#include "engine/TeEngineSettings.h"
#include "engine/TePatch.h"
#include "engine/TeStatistics.h"
#include "engine/camera/TeCameraRig.h"
#include "engine/hud/TeHud.h"
#include "engine/jobs/TeJob.h"
#include "engine/objects/TeObjects.h"
#include "generators/TeGenerator.h"
#include "nodes/TePatchGraphBuilder.h"
#include "patchdb/TePatchDatabase.h"

#include <Inventor/SbVec2d.h>
#include <Inventor/SbVec2f.h>
#include <Inventor/SbVec2s.h>

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

class TeEngineRuntime;

/// An endless terrain for an Inventor program, with the calls of document 002.
///
///     TeEngine* engine = new TeEngine(SbVec2s(65, 65), SbVec2f(64.0f, 64.0f));
///     TePatch* patch = engine->getPatch(SbVec2f(0.0f, 0.0f));
///     patch->prepareBuildMaps();
///     patch->buildHMapFromBuildMaps();
///     root->addChild(patch->getPatchGraph());
///
/// Calls that fail return NULL or FALSE, change nothing, leave one line in lastError() and send it to TeLog.
/// Ownership: the caller deletes the engine; the engine deletes its patches; graphs are Coin nodes, which
/// live on in the scenes that hold them. For the thread that makes all Coin calls, after SoDB::init().
///
/// Endless terrain in a scene:
///
///     engine->setSceneRoot(scene);            // with the camera, lights and what else belongs to the world
///     engine->setSceneCamera(camera);
///     engine->setHudRoot(hud);                // optional; drawn after the scene, with a camera of its own
///     engine->setHudCamera(hudCamera);
///     engine->setActiveObject(engine->addObject(std::make_unique<TeAircraft>("mine")));
///     if (!engine->initialize()) ...          // says what is missing
///     engine->timeTick(dt);                   // before every frame; or a TeEngineLoop does it
class TeEngine {
public:
  /// A patch became known (heightAt() and the like work there) or was forgotten. `graph`: what is in the
  /// scene as long as the patch belongs to the block; a program may add its own nodes.
  using PatchCallback = TeEngineSettings::PatchCallback;
  /// A patch that cannot be made, an object that was stopped, a job of the program that failed, parameters of
  /// the generator that are not usable.
  using ErrorCallback = TeEngineSettings::ErrorCallback;
  /// After objects were updated; `dt` is the simulated time of the tick. Not called while none moves.
  using CollisionHook = TeEngineSettings::CollisionHook;
  /// True if the key meant something to it.
  using KeyCallback = TeEngineSettings::KeyCallback;

  /// `samples`: of a source map, both sides equal and odd, 5 .. 16385. `area`: metres that a source map
  /// covers, both sides equal; a patch covers half a side, here 32×32 m. Bad arguments: isValid() is FALSE
  /// and every other call fails.
  TeEngine(const SbVec2s& samples, const SbVec2f& area);
  ~TeEngine();
  TeEngine(const TeEngine&) = delete;
  TeEngine& operator=(const TeEngine&) = delete;

  SbBool isValid() const { return m_database != nullptr; }
  /// The last failed call's error; empty if none has failed.
  const std::string& lastError() const { return m_lastError; }

  /// The world's seed, 0 by default. FALSE once a patch exists.
  SbBool setSeed(std::uint64_t seed);
  /// The weights of the four source maps of a patch, smooth by default. FALSE once a patch exists.
  SbBool setBlending(TeBlendProfile profile);
  /// The generator by specification (TeGeneratorRegistry), with filters over it; its
  /// kDefaultGenerator alone by default.
  /// Maps made before keep theirs, and blending joins the two. FALSE, and the generator as before: unknown
  /// names or unusable parameters.
  SbBool setGenerator(const std::string& specification, const std::vector<std::string>& filters = {});
  /// A generator of the program's own.
  SbBool setGenerator(std::unique_ptr<TeGenerator> generator);
  /// Its public parameters may be changed at any time: they hold for the maps made from then on. Only if
  /// valid.
  TeGenerator& getGenerator() { return *m_generator; }

  /// The point of the world that graphs have at their (0, 0, 0); (0, 0) by default. Coin's coordinates are
  /// float, so choose it near what is shown. Moves the graphs made before, too.
  SbBool setOrigin(const SbVec2d& point);
  /// How graphs made from now on look: colours, a draped image. NULL if not valid.
  TePatchGraphBuilder* getGraphBuilder();

  /// The patch that contains a point, metres; usually its centre is given. Made if it was not known, without
  /// heights. NULL: the point is not finite or beyond the range of keys.
  TePatch* getPatch(const SbVec2f& point);
  TePatch* getPatch(const SbVec2d& point);
  TePatch* getPatch(const TePatchKey& key);

  /// All known terrain, for queries: heights, normals, rays. NULL if not valid. setSeed() and setBlending()
  /// make a new one.
  const TePatchDatabase* getDatabase() const { return m_database.get(); }

  // Endless terrain. What is set here has to be set before initialize(), unless it says otherwise; FALSE, and
  // nothing changed: a value out of range, or too late.

  /// Where terrain and objects are added, at the end. The engine holds references to all these nodes.
  SbBool setSceneRoot(SoSeparator* root);
  SbBool setSceneCamera(SoPerspectiveCamera* camera); ///< somewhere below the scene root
  SbBool setHudRoot(SoSeparator* root);
  SbBool setHudCamera(SoOrthographicCamera* camera);

  /// The engine owns the object. At any time. NULL: no object, or a place that is not finite.
  TeObject* addObject(std::unique_ptr<TeObject> object);
  /// At any time; the active object only after another one was made active. FALSE: not one of the engine's.
  SbBool removeObject(TeObject* object);
  /// The object that the camera follows, that has the keys, and around which terrain is shown. At any time.
  SbBool setActiveObject(TeObject* object);
  TeObject* getActiveObject() const { return m_settings.active; }
  const TeObjects& getObjects() const { return m_objects; }

  /// The block has (2r + 1)² patches; 1 .. kMaxRadius, by default 1. At any time.
  SbBool setRadius(int radius);
  /// CPU seconds that a tick may spend, more than 0 and at most 1; kDefaultBudget by default. With a frame
  /// rate it is where the budget begins. At any time.
  SbBool setBudget(double seconds);
  /// Units of work a tick instead of time, so that runs repeat to the bit; 0 = time. At any time.
  SbBool setUnitBudget(int units);
  /// Wanted frames a second, 1 .. 1000: the budget then adapts to what drawing leaves of a frame
  /// (TeFrameBudget). 0, the default: a fixed budget. At any time.
  SbBool setFrameRate(double framesPerSecond);
  /// Largest deviation that is wanted of what is drawn from the surface of all samples, in pixels, 0 ..
  /// kMostPixelError: patches that are far away are then drawn with fewer triangles (TeGridLevels). 0, the
  /// default: all triangles. Picking, collision and heights stay those of all samples. At any time.
  SbBool setPixelError(double pixels);
  /// Wanted frames a second, 1 .. 1000: the pixel error is then chosen so that drawing takes no more than
  /// kDrawingShare of a frame (TeQuality); it begins with 1. Of the two that share a frame, making terrain
  /// gives way first: with setFrameRate() its budget is what drawing leaves, at once; the error then gives it
  /// back what is its own. 0, the default: setPixelError() counts. At any time.
  SbBool setQualityGoal(double framesPerSecond);
  /// What a quality goal may choose from, pixels, 0 < finest <= coarsest <= kMostPixelError; TeQuality's
  /// kFinest to kCoarsest by default. At any time.
  SbBool setQualityRange(double finest, double coarsest);
  /// Threads that fill source maps; 0 by default, at most kMaxWorkers.
  SbBool setWorkers(int workers);
  /// Of terrain made from now on; by default rock and snow lines that suit the world. At any time.
  void setColours(const TeSurfaceColours& colours);

  /// Checks that everything is there and that it fits together, builds the patches below all objects, and
  /// fills the scene roots. FALSE: lastError() says all that is missing.
  SbBool initialize();
  SbBool isInitialized() const { return m_runtime != nullptr; }
  /// One turn of the loop: events, objects, the collision hook, terrain below each object, slices of
  /// generation, hand-over to the scene, call-backs, statistics. FALSE, and nothing done: not initialised;
  /// dt is negative or not finite; a call-back calls it that is not of the tick's end. Of more than
  /// TeObjects::kLongestTick seconds the rest is dropped.
  SbBool timeTick(double dt);
  /// Works until nothing is left to be made for objects as they are now, whatever the budget, and hands it to
  /// the scene. Does nothing within an object's update() or a job's step().
  void finishJobs();
  /// Nothing moves and nothing is to be made: no tick is needed before the next event.
  bool isIdle() const;
  /// Objects or the camera move: ticks are wanted frame by frame. Else only jobs are left, if not idle.
  bool isMoving() const;
  /// True if the last tick, or a call since, changed what is seen.
  bool needsRedraw() const;
  /// The host says that it has drawn a frame: seconds of the wall clock since the frame before, of CPU time
  /// for drawing it, and of the wall clock from the beginning of drawing until OpenGL was done with it; 0 if
  /// that is not known: a quality goal then goes by the CPU time, and by the frame where it is late.
  void frameDrawn(double frameSeconds, double drawSeconds, double finishSeconds = 0);

  /// Queues a key for the next tick; only once initialised.
  void postKey(const TeKeyEvent& event);
  // Call-backs come at the end of a tick (keys at its beginning, objects that were stopped and collisions
  // after objects), in the order of what they tell, and may call the engine, but not delete it. At any time.

  /// Gets the keys that neither the active object, the camera nor the engine uses.
  void setKeyCallback(KeyCallback callback) { m_settings.key = std::move(callback); }
  void setPatchReadyCallback(PatchCallback callback) { m_settings.patchReady = std::move(callback); }
  void setPatchDroppedCallback(PatchCallback callback) { m_settings.patchDropped = std::move(callback); }
  void setErrorCallback(ErrorCallback callback) { m_settings.error = std::move(callback); }
  void setCollisionHook(CollisionHook hook) { m_settings.collisions = std::move(hook); }

  // Only once initialised.

  /// Work of the program's own, of kind TeJobKind::Other. The engine owns it. FALSE, and the job is gone:
  /// none was given, or not initialised.
  SbBool addJob(std::unique_ptr<TeJob> job);
  SbBool setPaused(SbBool paused); ///< objects stand still; terrain is made all the same
  SbBool isPaused() const;
  SbBool setWireframe(SbBool wireframe);
  SbBool isWireframe() const;
  const TeStatistics& getStatistics() const; ///< all 0 before

  TeCameraRig& getCameraRig() { return m_rig; }
  /// After SoDB::init().
  TeHud& getHud();
  /// Of all objects and the camera; after finishJobs() with withTerrain of every patch of the block, too.
  std::uint64_t stateHash(bool withTerrain = false) const;

  static constexpr int kMaxRadius = 64;
  static constexpr int kMaxWorkers = 64;
  static constexpr double kDefaultBudget = TeFrameBudget::kDefault;
  static constexpr double kMostPixelError = TeQuality::kMostPixels;
  /// Of a frame. The rest is for making terrain, and TeFrameBudget::kMargin.
  static constexpr double kDrawingShare = 0.75;

private:
  friend class TePatch;
  SbBool fail(const TeError& error);
  /// Says what setting is out of range, or too late.
  SbBool checkSetting(bool good, const std::string& setting);
  SbBool checkEarly(const std::string& setting);
  template <class Node> SbBool setNode(TeNodePtr<Node>& setting, Node* node, const char* what);
  /// Hands the generator's present parameters to the database.
  SbBool updateParams();
  TeStatus takeParams();
  /// Parameters that are not usable are reported once, and those before stay.
  void takeParamsForTick();
  SbBool createDatabase();
  /// Null before SoDB::init().
  TeNodePtr<SoSeparator> makeGraph(const TePatchMesh& mesh);

  bool m_usable = false; ///< the constructor's arguments were good
  TeLattice m_lattice;
  std::uint64_t m_seed = 0;
  TeBlendProfile m_blending = TeBlendProfile::Smooth;
  std::unique_ptr<TeGenerator> m_generator;
  TeHeightSourcePtr m_source;
  std::unique_ptr<TePatchDatabase> m_database;
  SbVec2d m_origin{0, 0};
  std::unique_ptr<TePatchGraphBuilder> m_graphs; ///< made when first needed
  std::unordered_map<TePatchKey, std::unique_ptr<TePatch>, TePatchKeyHash> m_patches;
  std::string m_lastError;
  std::string m_paramsFault;                   ///< of the last tick; empty if there was none
  std::optional<std::uint64_t> m_paramsOfTick; ///< hash of those that the last tick took

  TeEngineSettings m_settings;
  TeObjects m_objects;
  TeCameraRig m_rig;
  std::unique_ptr<TeHud> m_hud;               ///< made when first needed, for it needs Coin
  std::unique_ptr<TeEngineRuntime> m_runtime; ///< refers to all of the above
};
