#pragma once

#include "engine/TeStatistics.h"
#include "engine/jobs/TeJobQueue.h"
#include "engine/jobs/TeMapMaker.h"
#include "engine/terrain/TeBlockCount.h"
#include "engine/terrain/TePatchCandidates.h"
#include "engine/terrain/TeTerrainPatch.h"
#include "engine/terrain/TeTerrainPlan.h"
#include "engine/terrain/TeTerrainScene.h"
#include "nodes/TeSurfaceColours.h"
#include "patchdb/TeKeySet.h"

#include <deque>
#include <functional>
#include <limits>
#include <unordered_map>
#include <vector>

/// Keeps the right patches known and drawn: the block around the active object, those that will be needed
/// soon, and one below every other object. What is wanted becomes jobs in the queue; what nobody wants any
/// more is dropped, a few patches a tick.
///
/// A patch within one of the block's rim is kept, so that an object that moves to and fro over an edge has
/// nothing made again. Source maps are freed with the last of the patches that share them.
class TeTerrain {
public:
  /// Patches that stay known beyond the block's rim.
  static constexpr int kKeep = 1;
  static constexpr std::int64_t kBytesPerUnit = 1 << 16; ///< of uploads, where work is counted in units
  static constexpr std::int64_t kRetryTicks = 100;       ///< after a patch or a piece of it could not be made

  struct Event {
    enum class Kind { Ready, Dropped, Failed };
    Kind kind;
    TePatchKey key;
    TeNodePtr<SoGroup> graph;
    std::string message; ///< of Failed
  };
  /// Patches that must never be dropped, for a program holds them.
  using Held = std::function<bool(const TePatchKey& key)>;

  TeTerrain(TePatchDatabase& database, TeTerrainScene& scene, TeJobQueue& queue, TeMapMaker& maps, Held held);
  ~TeTerrain();
  TeTerrain(const TeTerrain&) = delete;
  TeTerrain& operator=(const TeTerrain&) = delete;

  void setRadius(int radius) { m_plan.setRadius(radius); }
  /// For pieces made from now on.
  void setColours(const TeSurfaceColours& colours) { m_colours = colours; }

  /// The patch below an object is wanted from now on, wherever it is. `active`: see TeTerrainPlan.
  void place(const TeObject& object, bool active) { m_plan.place(object, m_database.lattice(), active); }
  void forget(const TeObject& object) { m_plan.forget(object); }

  /// Makes a patch known at once.
  TeStatus build(const TePatchKey& key);
  /// The same for the patches below all objects, so that what these do does not depend on the budget from the
  /// start. Those that cannot be made are left to be tried, and reported, by jobs.
  void buildGround();
  /// Finds what is wanted for this view; changes jobs and scene where that has changed. True if the whole
  /// block was left behind.
  bool follow(const TeTerrainView& view);
  /// Drops what is old, shows what is ready, and works on the queue, within the allowance.
  void work(TeAllowance& allowance);

  /// Nothing is left to be made, shown or dropped.
  bool idle() const;
  /// Nothing is left to be made but what could not be made lately.
  bool complete() const { return m_queue.empty() && m_candidates.empty(); }
  /// True once after something in the scene has changed.
  bool takeChanged() { return std::exchange(m_changed, false); }
  std::vector<Event> takeEvents() { return std::move(m_events); }
  const TePatchBlock& block() const { return m_plan.block(); }
  bool hasGround(const glm::dvec3& position) const;
  void count(TeStatistics& statistics);
  /// Of the heights of the block's patches.
  std::uint64_t hash() const;

private:
  using Patches = std::unordered_map<TePatchKey, TeTerrainPatch, TePatchKeyHash>;
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  struct Shown {
    TeUrgency urgency;
    TePatchKey owner;
    TeTerrainPiece piece;
  };

  bool kept(const TePatchKey& key) const;
  bool hasHeights(const TePatchKey& key) const;
  TeJobKind kindOf(const TePatchKey& key) const;
  TeJobKind kindOf(const TePatchKey& owner, TeTerrainPiece piece) const;
  TeUrgency urgencyOf(const TePatchKey& key, TeTerrainPiece piece = TeTerrainPiece::Inside) const;
  bool inView(const TePatchKey& key) const;
  /// Or one of the patches to its west and south is, whose seams need it.
  bool neededInView(const TePatchKey& key) const;

  void replan();
  void reviewJobs();
  bool reviewJob(TeJob& job, TeJobKind& kind, TeUrgency& urgency);
  /// Notes that a patch is missing, unless it is being made.
  void want(const TePatchKey& key, TeJobKind kind);
  void findCandidates();
  /// Turns the most urgent candidates into jobs.
  void fillQueue();
  void gotHeights(const TePatchKey& key);
  void finished(TeJob& job, TeProgress progress);
  void makePiece(const TePatchKey& owner, TeTerrainPiece piece);
  /// Whether it is too early for what has failed lately.
  bool waits(const TeTerrainPatch& patch);
  void failed(const TePatchKey& key, TeTerrainPatch& patch, const TeJob& job);
  void updateScene();
  void updatePatch(const TePatchKey& key, TeTerrainPatch& patch);
  void show(TeAllowance& allowance);
  void dropOld(TeAllowance& allowance);
  void drop(const TePatchKey& key);
  bool complete(const TePatchKey& key) const;

  TePatchDatabase& m_database;
  TeTerrainScene& m_scene;
  TeJobQueue& m_queue;
  TeMapMaker& m_maps;
  Held m_held;
  TeSurfaceColours m_colours;
  TeTerrainView m_view;
  TeTerrainView m_reviewedView; ///< for which urgencies were found
  TeTerrainPlan m_plan;
  TePatchCandidates m_candidates;
  Patches m_patches;
  std::vector<Shown> m_toShow;
  std::deque<TePatchKey> m_toDrop;
  std::int64_t m_unitBytes = 0; ///< of uploads that do not make a unit yet
  std::int64_t m_ticks = 0;
  std::int64_t m_retryTick = kNever; ///< when something that has failed is due again
  float m_lowest = 0;                ///< of all patches ever known
  float m_highest = 0;
  bool m_changed = false;
  bool m_blockChanged = false;
  TeBlockCount m_blockCount;
  std::vector<Event> m_events;
  TeKeySet m_madeKeys;
  std::int64_t m_resident = 0;
  std::int64_t m_made = 0;
  std::int64_t m_madeAgain = 0;
  std::int64_t m_dropped = 0;
  std::size_t m_heightBytes = 0;
  std::size_t m_meshBytes = 0;
};
