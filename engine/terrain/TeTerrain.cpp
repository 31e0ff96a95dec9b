#include "engine/terrain/TeTerrain.h"

#include "engine/terrain/TeHeightsJob.h"
#include "engine/terrain/TePieceJob.h"
#include "generators/base/TeHash.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// The camera has to turn so far, as the cosine of the angle, or the object to move so far, in patches,
/// before urgencies are found anew.
constexpr double kTurned = 0.996;
constexpr double kMoved = 0.5;

std::size_t bytesOf(const SoTeTerrainMesh& node) {
  return node.mesh()->bytes() + node.mesh()->positions.size() * 4;
}

} // namespace

TeTerrain::TeTerrain(TePatchDatabase& database, TeTerrainScene& scene, TeJobQueue& queue, TeMapMaker& maps,
                     Held held)
    : m_database(database), m_scene(scene), m_queue(queue), m_maps(maps), m_held(std::move(held)) {
  m_queue.setFinished([this](TeJob& job, TeProgress progress) { finished(job, progress); });
}

TeTerrain::~TeTerrain() { m_queue.setFinished({}); }

TeStatus TeTerrain::build(const TePatchKey& key) {
  if (const TeResult<TePatchData*> built = m_database.build(key); !built)
    return built.error();
  TeTerrainPatch& patch = m_patches[key];
  if (patch.hasHeights)
    return {};
  if (patch.heightsJob) {
    m_candidates.unqueued(patch.heightsJob->kind());
    m_queue.cancel(*patch.heightsJob);
    patch.heightsJob = nullptr;
  }
  gotHeights(key);
  return {};
}

void TeTerrain::buildGround() {
  std::vector<TePatchKey> keys;
  m_plan.pins().forEach([&keys](const TePatchKey& key) { keys.push_back(key); });
  std::sort(keys.begin(), keys.end());
  for (const TePatchKey& key : keys)
    static_cast<void>(build(key));
}

bool TeTerrain::hasHeights(const TePatchKey& key) const {
  const auto found = m_patches.find(key);
  return found != m_patches.end() && found->second.hasHeights;
}

bool TeTerrain::hasGround(const glm::dvec3& position) const {
  const TeResult<TePatchKey> key = tePatchAt(m_database.lattice(), {position.x, position.y});
  return key && hasHeights(*key);
}

bool TeTerrain::kept(const TePatchKey& key) const {
  return TePatchBlock{block().centre, block().radius + kKeep}.contains(key) || m_plan.wanted(key) ||
         m_held(key);
}

bool TeTerrain::inView(const TePatchKey& key) const {
  const glm::dvec2 southWest = tePatchOrigin(m_database.lattice(), key);
  const double side = m_database.lattice().patchSide();
  return m_view.frustum.meets({southWest, m_lowest}, {southWest + side, m_highest});
}

bool TeTerrain::neededInView(const TePatchKey& key) const {
  const double side = m_database.lattice().patchSide();
  const glm::dvec2 northEast = tePatchOrigin(m_database.lattice(), key) + side;
  return m_view.frustum.meets({northEast - 2 * side, m_lowest}, {northEast, m_highest});
}

TeJobKind TeTerrain::kindOf(const TePatchKey& key) const {
  if (m_plan.pins().holds(key) || key == block().centre)
    return TeJobKind::Ground;
  return m_plan.inBlock(key) ? TeJobKind::Block : TeJobKind::Ahead;
}

TeJobKind TeTerrain::kindOf(const TePatchKey& owner, TeTerrainPiece piece) const {
  return m_plan.inBlock(owner, piece) ? TeJobKind::Block : TeJobKind::Ahead;
}

TeUrgency TeTerrain::urgencyOf(const TePatchKey& key, TeTerrainPiece piece) const {
  const glm::dvec2 way = tePatchCentre(m_database.lattice(), key) - glm::dvec2(m_view.position);
  TeUrgency urgency{0, glm::length(way), key, int(piece)};
  switch (kindOf(key)) {
  case TeJobKind::Ground:
    urgency.rank = key == block().centre ? 0 : 1;
    break;
  case TeJobKind::Block:
    urgency.rank = neededInView(key) ? 0 : 1;
    break;
  default:
    break;
  }
  return urgency;
}

bool TeTerrain::follow(const TeTerrainView& view) {
  ++m_ticks;
  m_view = view;
  const bool changed = m_plan.update(m_database.lattice(), view);
  if (changed || m_ticks >= m_retryTick) {
    m_retryTick = kNever;
    replan();
  } else if (!complete()) {
    const double side = m_database.lattice().patchSide();
    if (glm::dot(m_view.frustum.direction(), m_reviewedView.frustum.direction()) < kTurned ||
        glm::distance(m_view.position, m_reviewedView.position) > kMoved * side)
      reviewJobs();
  }
  return m_plan.jumped();
}

void TeTerrain::replan() {
  m_blockChanged = m_blockChanged || m_plan.blockChanged();
  reviewJobs();
  updateScene();
}

void TeTerrain::want(const TePatchKey& key, TeJobKind kind) {
  if (const auto found = m_patches.find(key); found != m_patches.end()) {
    const TeTerrainPatch& patch = found->second;
    if (patch.hasHeights || patch.heightsJob || waits(patch))
      return;
  }
  // A program may have built it by itself.
  if (const TePatchData* data = m_database.find(key); data && data->hasHeights())
    gotHeights(key);
  else
    m_candidates.add(kind, urgencyOf(key));
}

void TeTerrain::findCandidates() {
  m_candidates.clear();
  m_plan.pins().forEach([this](const TePatchKey& key) { want(key, TeJobKind::Ground); });
  block().forEach([this](const TePatchKey& key) { want(key, kindOf(key)); });
  m_plan.forEachAhead([this](const TePatchKey& key) { want(key, kindOf(key)); });
  m_candidates.sort();
}

void TeTerrain::fillQueue() {
  if (m_candidates.outdated())
    findCandidates();
  for (const TeJobKind kind : {TeJobKind::Ground, TeJobKind::Block, TeJobKind::Ahead}) {
    TeUrgency urgency;
    while (m_candidates.take(kind, urgency)) {
      TeTerrainPatch& patch = m_patches[urgency.key];
      if (patch.hasHeights || patch.heightsJob) // it was foreseen twice
        continue;
      patch.heightsJob =
          &m_queue.add(std::make_unique<TeHeightsJob>(m_database, m_maps, urgency.key, kind, urgency));
      m_candidates.queued(kind);
    }
  }
}

void TeTerrain::makePiece(const TePatchKey& owner, TeTerrainPiece piece) {
  const auto found = m_patches.find(owner);
  if (found == m_patches.end())
    return;
  TeTerrainPatch::Piece& record = found->second[piece];
  if (record.job || record.made ||
      !tePieceAll(owner, piece,
                  [this](const TePatchKey& key) { return m_plan.drawable(key) && hasHeights(key); }) ||
      waits(found->second))
    return;
  record.job = &m_queue.add(std::make_unique<TePieceJob>(
      m_database, owner, piece, m_colours, m_scene.drawing(), kindOf(owner, piece), urgencyOf(owner, piece)));
}

void TeTerrain::gotHeights(const TePatchKey& key) {
  TeTerrainPatch& patch = m_patches[key];
  const TePatchData* data = m_database.find(key);
  patch.hasHeights = true;
  patch.graph = TeNodePtr<SoGroup>(new SoGroup);
  m_heightBytes += data->heights().bytes();
  m_lowest = m_made == 0 ? data->minimum() : std::min(m_lowest, data->minimum());
  m_highest = m_made == 0 ? data->maximum() : std::max(m_highest, data->maximum());
  ++m_made;
  ++m_resident;
  if (!m_madeKeys.insert(key.x, key.y))
    ++m_madeAgain;
  m_events.push_back({Event::Kind::Ready, key, patch.graph, {}});
  if (m_plan.drawable(key))
    tePiecesAround(key, [this](const TePatchKey& owner, TeTerrainPiece piece) { makePiece(owner, piece); });
  updatePatch(key, patch);
}

void TeTerrain::finished(TeJob& job, TeProgress progress) {
  if (auto* heights = dynamic_cast<TeHeightsJob*>(&job)) {
    TeTerrainPatch& patch = m_patches[heights->key()];
    patch.heightsJob = nullptr;
    m_candidates.unqueued(job.kind());
    if (progress == TeProgress::Done) {
      gotHeights(heights->key());
    } else {
      failed(heights->key(), patch, job);
    }
  } else if (auto* made = dynamic_cast<TePieceJob*>(&job)) {
    TeTerrainPatch& patch = m_patches[made->owner()];
    TeTerrainPatch::Piece& piece = patch[made->piece()];
    piece.job = nullptr;
    if (progress == TeProgress::Done) {
      piece.node = made->take();
      piece.made = true;
      if (piece.node)
        m_meshBytes += bytesOf(*piece.node);
      updatePatch(made->owner(), patch);
    } else {
      failed(made->owner(), patch, job);
    }
  } else if (progress == TeProgress::Failed) { // one of the program's
    m_events.push_back({Event::Kind::Failed, {}, nullptr, job.failure().message});
  }
}

bool TeTerrain::waits(const TeTerrainPatch& patch) {
  if (m_ticks >= patch.retryTick)
    return false;
  m_retryTick = std::min(m_retryTick, patch.retryTick);
  return true;
}

void TeTerrain::failed(const TePatchKey& key, TeTerrainPatch& patch, const TeJob& job) {
  patch.retryTick = m_ticks + kRetryTicks;
  m_retryTick = std::min(m_retryTick, patch.retryTick);
  m_events.push_back({Event::Kind::Failed, key, nullptr, job.failure().message});
}

void TeTerrain::reviewJobs() {
  m_reviewedView = m_view;
  m_candidates.clearQueued();
  m_queue.review(
      [this](TeJob& job, TeJobKind& kind, TeUrgency& urgency) { return reviewJob(job, kind, urgency); });
  findCandidates();
}

bool TeTerrain::reviewJob(TeJob& job, TeJobKind& kind, TeUrgency& urgency) {
  if (const auto* heights = dynamic_cast<const TeHeightsJob*>(&job)) {
    if (!m_plan.wanted(heights->key())) {
      m_patches.erase(heights->key());
      return false;
    }
    kind = kindOf(heights->key());
    m_candidates.queued(kind);
    urgency = urgencyOf(heights->key());
  } else if (const auto* made = dynamic_cast<const TePieceJob*>(&job)) {
    if (!m_plan.drawable(made->owner(), made->piece())) {
      m_patches[made->owner()][made->piece()].job = nullptr;
      return false;
    }
    kind = kindOf(made->owner(), made->piece());
    urgency = urgencyOf(made->owner(), made->piece());
  }
  return true;
}

void TeTerrain::updateScene() {
  m_toShow.clear();
  m_toDrop.clear();
  for (auto& [key, patch] : m_patches) {
    updatePatch(key, patch);
    if (patch.hasHeights && m_plan.drawable(key)) {
      for (const TeTerrainPiece piece : kTeTerrainPieces)
        if (!patch[piece].made && !patch[piece].job)
          makePiece(key, piece);
    } else if (!kept(key)) {
      m_toDrop.push_back(key);
    }
  }
  std::sort(m_toDrop.begin(), m_toDrop.end());
}

void TeTerrain::updatePatch(const TePatchKey& key, TeTerrainPatch& patch) {
  if (!patch.hasHeights)
    return;
  const bool inBlock = m_plan.inBlock(key);
  if (inBlock != patch.inScene) {
    inBlock ? m_scene.add(patch.graph.get()) : m_scene.remove(patch.graph.get());
    patch.inScene = inBlock;
    m_changed = true;
  }
  for (const TeTerrainPiece part : kTeTerrainPieces) {
    TeTerrainPatch::Piece& piece = patch[part];
    if (!piece.made)
      continue;
    const bool show = m_plan.inBlock(key, part);
    if (show && !piece.shown)
      m_toShow.push_back({urgencyOf(key, part), key, part});
    if (!show && piece.shown) {
      if (piece.node)
        patch.graph->removeChild(piece.node.get());
      piece.shown = false;
      m_changed = true;
    }
  }
}

void TeTerrain::show(TeAllowance& allowance) {
  std::sort(m_toShow.begin(), m_toShow.end(),
            [](const Shown& a, const Shown& b) { return a.urgency < b.urgency; });
  std::size_t shown = 0;
  for (; shown < m_toShow.size(); ++shown) {
    if (shown > 0 && allowance.exhausted())
      break;
    const Shown& next = m_toShow[shown];
    const auto patch = m_patches.find(next.owner);
    if (patch == m_patches.end())
      continue;
    TeTerrainPatch::Piece& piece = patch->second[next.piece];
    if (piece.shown || !piece.made)
      continue;
    piece.shown = true;
    m_changed = true;
    if (!piece.node)
      continue;
    patch->second.graph->addChild(piece.node.get());
    const std::size_t bytes = piece.node->uploadBytes();
    m_unitBytes += std::int64_t(bytes);
    allowance.charge(m_scene.drawing()->uploadSeconds(bytes), m_unitBytes / kBytesPerUnit);
    m_unitBytes %= kBytesPerUnit;
  }
  m_toShow.erase(m_toShow.begin(), m_toShow.begin() + std::ptrdiff_t(shown));
}

void TeTerrain::dropOld(TeAllowance& allowance) {
  // Twice as fast as patches can be made, so that memory is bounded; deleting one is far cheaper.
  constexpr int kPatchesPerUnit = 2;
  for (int unit = 0; unit < 16 && !m_toDrop.empty(); ++unit) {
    for (int i = 0; i < kPatchesPerUnit && !m_toDrop.empty(); ++i) {
      drop(m_toDrop.front());
      m_toDrop.pop_front();
    }
    if (!allowance.spend())
      break;
  }
}

void TeTerrain::drop(const TePatchKey& key) {
  const auto found = m_patches.find(key);
  if (found == m_patches.end() || kept(key))
    return;
  // Seams go with any of the patches that meet in them.
  tePiecesAround(key, [&](const TePatchKey& owner, TeTerrainPiece part) {
    const auto patch = m_patches.find(owner);
    if (patch == m_patches.end())
      return;
    TeTerrainPatch::Piece& piece = patch->second[part];
    if (piece.job)
      m_queue.cancel(*piece.job);
    if (piece.node)
      m_meshBytes -= bytesOf(*piece.node);
    piece = {};
  });
  if (found->second.hasHeights) {
    m_heightBytes -= m_database.find(key)->heights().bytes();
    --m_resident;
    ++m_dropped;
    m_events.push_back({Event::Kind::Dropped, key, found->second.graph, {}});
  }
  m_patches.erase(found);
  m_database.remove(key);
}

void TeTerrain::work(TeAllowance& allowance) {
  dropOld(allowance);
  show(allowance);
  do
    fillQueue();
  while (m_queue.run(allowance) && !allowance.exhausted() && !m_candidates.empty());
  if (!m_toShow.empty() && !allowance.exhausted())
    show(allowance);
}

bool TeTerrain::idle() const {
  return m_queue.empty() && m_candidates.empty() && m_toShow.empty() && m_toDrop.empty() &&
         !m_plan.outdated() && !m_scene.drawing()->changesAnchor();
}

bool TeTerrain::complete(const TePatchKey& key) const {
  const auto found = m_patches.find(key);
  if (found == m_patches.end())
    return false;
  for (const TeTerrainPiece part : kTeTerrainPieces)
    if (!found->second.pieces[std::size_t(part)].shown && m_plan.inBlock(key, part))
      return false;
  return true;
}

void TeTerrain::count(TeStatistics& statistics) {
  if (std::exchange(m_blockChanged, false))
    m_blockCount.begin(block());
  m_blockCount.update([this](const TePatchKey& key) { return complete(key); },
                      [this](const TePatchKey& key) { return inView(key); });
  statistics.patches = m_blockCount.counts();
  statistics.patches.resident = m_resident;
  statistics.patches.made = m_made;
  statistics.patches.madeAgain = m_madeAgain;
  statistics.patches.dropped = m_dropped;
  statistics.memory.heights = m_heightBytes;
  statistics.memory.meshes = m_meshBytes;
  statistics.memory.maps = m_database.maps().residentBytes();
  statistics.memory.buffers = m_scene.drawing()->bufferBytes();
  statistics.memory.records = m_madeKeys.bytes() + m_database.maps().recordBytes();
}

std::uint64_t TeTerrain::hash() const {
  std::uint64_t hash = teMix(std::uint64_t(block().radius));
  block().forEach([&](const TePatchKey& key) {
    hash = teHashCombine(hash, std::uint64_t(key.x));
    hash = teHashCombine(hash, std::uint64_t(key.y));
    if (const TePatchData* patch = m_database.find(key); patch && patch->hasHeights())
      hash = teHashCombine(hash, teHashBytes(patch->heights().row(0), patch->heights().bytes()));
  });
  return hash;
}
