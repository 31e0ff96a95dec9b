#include "engine/terrain/TeTerrain.h"

#include "engine/terrain/TeHeightsJob.h"
#include "engine/terrain/TeLookAhead.h"
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

void TeTerrain::setRadius(int radius) {
  m_block.radius = radius;
  m_planned = false;
}

void TeTerrain::place(const TeObject& object) {
  m_pinsChanged = m_pins.place(object, m_database.lattice()) || m_pinsChanged;
}

void TeTerrain::forget(const TeObject& object) {
  m_pins.remove(object);
  m_pinsChanged = true;
}

TeStatus TeTerrain::build(const TePatchKey& key) {
  if (const TeResult<TePatchData*> built = m_database.build(key); !built)
    return built.error();
  TeTerrainPatch& patch = m_patches[key];
  if (patch.heightsJob) {
    m_queue.cancel(*patch.heightsJob);
    patch.heightsJob = nullptr;
  }
  gotHeights(key);
  return {};
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
  return TePatchBlock{m_block.centre, m_block.radius + kKeep}.contains(key) || wanted(key) || m_held(key);
}

bool TeTerrain::inView(const TePatchKey& key) const {
  const glm::dvec2 southWest = tePatchOrigin(m_database.lattice(), key);
  const double side = m_database.lattice().patchSide();
  double lowest = m_lowest;
  double highest = m_highest;
  if (const TePatchData* patch = m_database.find(key); patch && patch->hasHeights()) {
    lowest = patch->minimum();
    highest = patch->maximum();
  }
  return m_view.frustum.meets({southWest, lowest}, {southWest + side, highest});
}

TeJobKind TeTerrain::kindOf(const TePatchKey& key) const {
  if (m_pins.holds(key) || key == m_block.centre)
    return TeJobKind::Ground;
  return m_block.contains(key) ? TeJobKind::Block : TeJobKind::Ahead;
}

TeUrgency TeTerrain::urgencyOf(const TePatchKey& key, TeTerrainPiece piece) const {
  const glm::dvec2 way = tePatchCentre(m_database.lattice(), key) - glm::dvec2(m_view.position);
  TeUrgency urgency{0, glm::length(way), key, int(piece)};
  switch (kindOf(key)) {
  case TeJobKind::Ground:
    urgency.rank = key == m_block.centre ? 0 : 1;
    break;
  case TeJobKind::Block:
    urgency.rank = inView(key) ? 0 : 1;
    break;
  default:
    break;
  }
  return urgency;
}

bool TeTerrain::follow(const TeTerrainView& view) {
  ++m_ticks;
  m_view = view;
  const TeResult<TePatchKey> centre = tePatchAt(m_database.lattice(), {view.position.x, view.position.y});
  if (!centre) // outside the world: what was shown last stays
    return false;
  const TePatchBlock block{*centre, m_block.radius};
  std::vector<TePatchKey> centres =
      TeLookAhead::centres(m_database.lattice(), glm::dvec2(view.position), glm::dvec2(view.velocity));
  const bool jumped = m_planned && (std::llabs(centre->x - m_block.centre.x) > 2 * block.radius ||
                                    std::llabs(centre->y - m_block.centre.y) > 2 * block.radius);
  if (!m_planned || m_pinsChanged || !(block == m_block) || centres != m_centres) {
    m_block = block;
    m_centres = std::move(centres);
    replan();
    return jumped;
  }
  if (m_ticks % kRetryTicks == 0)
    replan();
  const double side = m_database.lattice().patchSide();
  if (glm::dot(m_view.frustum.direction(), m_reviewedView.frustum.direction()) < kTurned ||
      glm::distance(m_view.position, m_reviewedView.position) > kMoved * side)
    reviewJobs();
  return false;
}

void TeTerrain::replan() {
  m_planned = true;
  m_blockChanged = true;
  m_pinsChanged = false;
  m_ahead.clear();
  const TePatchBlock* before = &m_block;
  TePatchBlock foreseen;
  for (const TePatchKey& centre : m_centres) {
    TePatchBlock next{centre, m_block.radius};
    next.forEach([&](const TePatchKey& key) {
      if (!m_block.contains(key) && !before->contains(key))
        m_ahead.insert(key);
    });
    foreseen = next;
    before = &foreseen;
  }
  reviewJobs();
  m_pins.forEach([this](const TePatchKey& key) { want(key); });
  m_block.forEach([this](const TePatchKey& key) { want(key); });
  for (const TePatchKey& key : m_ahead)
    want(key);
  updateScene();
}

void TeTerrain::want(const TePatchKey& key) {
  TeTerrainPatch& patch = m_patches[key];
  if (patch.heightsJob || m_ticks < patch.retryTick)
    return;
  if (!patch.hasHeights) {
    // A program may have built it by itself.
    if (const TePatchData* data = m_database.find(key); data && data->hasHeights())
      gotHeights(key);
    else
      patch.heightsJob =
          &m_queue.add(std::make_unique<TeHeightsJob>(m_database, m_maps, key, kindOf(key), urgencyOf(key)));
    return;
  }
  for (const TeTerrainPiece piece : kTeTerrainPieces)
    makePiece(key, piece);
}

void TeTerrain::makePiece(const TePatchKey& owner, TeTerrainPiece piece) {
  const auto found = m_patches.find(owner);
  if (found == m_patches.end())
    return;
  TeTerrainPatch::Piece& record = found->second[piece];
  if (record.job || record.made ||
      !tePieceAll(owner, piece, [this](const TePatchKey& key) { return drawable(key) && hasHeights(key); }))
    return;
  const bool inBlock =
      tePieceAll(owner, piece, [this](const TePatchKey& key) { return m_block.contains(key); });
  record.job = &m_queue.add(
      std::make_unique<TePieceJob>(m_database, owner, piece, m_colours, m_scene.drawing(),
                                   inBlock ? TeJobKind::Block : TeJobKind::Ahead, urgencyOf(owner, piece)));
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
  if (!m_madeKeys.insert(key).second)
    ++m_madeAgain;
  m_events.push_back({Event::Kind::Ready, key, patch.graph, {}});
  if (drawable(key))
    tePiecesAround(key, [this](const TePatchKey& owner, TeTerrainPiece piece) { makePiece(owner, piece); });
  updatePatch(key, patch);
}

void TeTerrain::finished(TeJob& job, TeProgress progress) {
  if (auto* heights = dynamic_cast<TeHeightsJob*>(&job)) {
    TeTerrainPatch& patch = m_patches[heights->key()];
    patch.heightsJob = nullptr;
    if (progress == TeProgress::Done) {
      gotHeights(heights->key());
    } else {
      patch.retryTick = m_ticks + kRetryTicks;
      m_events.push_back({Event::Kind::Failed, heights->key(), nullptr, heights->error().message});
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
      patch.retryTick = m_ticks + kRetryTicks;
      m_events.push_back({Event::Kind::Failed, made->owner(), nullptr, made->error().message});
    }
  }
}

void TeTerrain::reviewJobs() {
  m_reviewedView = m_view;
  m_queue.review(
      [this](TeJob& job, TeJobKind& kind, TeUrgency& urgency) { return reviewJob(job, kind, urgency); });
}

bool TeTerrain::reviewJob(TeJob& job, TeJobKind& kind, TeUrgency& urgency) {
  if (const auto* heights = dynamic_cast<const TeHeightsJob*>(&job)) {
    if (!wanted(heights->key())) {
      m_patches.erase(heights->key());
      return false;
    }
    kind = kindOf(heights->key());
    urgency = urgencyOf(heights->key());
  } else if (const auto* made = dynamic_cast<const TePieceJob*>(&job)) {
    if (!tePieceAll(made->owner(), made->piece(), [this](const TePatchKey& key) { return drawable(key); })) {
      m_patches[made->owner()][made->piece()].job = nullptr;
      return false;
    }
    kind = tePieceAll(made->owner(), made->piece(),
                      [this](const TePatchKey& key) { return m_block.contains(key); })
               ? TeJobKind::Block
               : TeJobKind::Ahead;
    urgency = urgencyOf(made->owner(), made->piece());
  }
  return true;
}

void TeTerrain::updateScene() {
  m_toShow.clear();
  m_toDrop.clear();
  for (auto& [key, patch] : m_patches) {
    updatePatch(key, patch);
    if (!kept(key))
      m_toDrop.push_back(key);
  }
  std::sort(m_toDrop.begin(), m_toDrop.end());
}

void TeTerrain::updatePatch(const TePatchKey& key, TeTerrainPatch& patch) {
  if (!patch.hasHeights)
    return;
  const bool inBlock = m_block.contains(key);
  if (inBlock != patch.inScene) {
    inBlock ? m_scene.add(patch.graph.get()) : m_scene.remove(patch.graph.get());
    patch.inScene = inBlock;
    m_changed = m_blockChanged = true;
  }
  for (const TeTerrainPiece part : kTeTerrainPieces) {
    TeTerrainPatch::Piece& piece = patch[part];
    if (!piece.made)
      continue;
    const bool show =
        tePieceAll(key, part, [this](const TePatchKey& other) { return m_block.contains(other); });
    if (show && !piece.shown)
      m_toShow.push_back({urgencyOf(key, part), key, part});
    if (!show && piece.shown) {
      if (piece.node)
        patch.graph->removeChild(piece.node.get());
      piece.shown = false;
      m_changed = m_blockChanged = true;
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
    m_changed = m_blockChanged = true;
    if (!piece.node)
      continue;
    patch->second.graph->addChild(piece.node.get());
    const std::size_t bytes = piece.node->uploadBytes();
    m_unitBytes += std::int64_t(bytes);
    allowance.charge(double(bytes) * m_scene.drawing()->secondsPerByte(), m_unitBytes / kBytesPerUnit);
    m_unitBytes %= kBytesPerUnit;
  }
  m_toShow.erase(m_toShow.begin(), m_toShow.begin() + std::ptrdiff_t(shown));
}

void TeTerrain::dropOld(TeAllowance& allowance) {
  // Twice as fast as patches can be made, so that memory is bounded; deleting one is far cheaper.
  constexpr int kPatchesPerUnit = 8;
  for (int unit = 0; unit < 4 && !m_toDrop.empty(); ++unit) {
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
  m_queue.run(allowance);
  if (!m_toShow.empty() && !allowance.exhausted())
    show(allowance);
}

bool TeTerrain::idle() const {
  return m_queue.empty() && m_toShow.empty() && m_toDrop.empty() && !m_pinsChanged &&
         !m_scene.drawing()->changesAnchor();
}

bool TeTerrain::complete(const TePatchKey& key) const {
  const auto found = m_patches.find(key);
  if (found == m_patches.end())
    return false;
  for (const TeTerrainPiece part : kTeTerrainPieces)
    if (!found->second.pieces[std::size_t(part)].shown &&
        tePieceAll(key, part, [this](const TePatchKey& other) { return m_block.contains(other); }))
      return false;
  return true;
}

void TeTerrain::countBlock() {
  m_blockCounts = {};
  m_block.forEach([this](const TePatchKey& key) {
    ++m_blockCounts.block;
    if (complete(key)) {
      ++m_blockCounts.drawn;
      return;
    }
    ++m_blockCounts.missing;
    m_blockCounts.missingInView += inView(key) ? 1 : 0;
  });
}

void TeTerrain::count(TeStatistics& statistics) {
  // What is complete stays so until the block or the scene changes.
  if (std::exchange(m_blockChanged, false) || m_blockCounts.missing > 0)
    countBlock();
  statistics.patches = m_blockCounts;
  statistics.patches.resident = m_resident;
  statistics.patches.made = m_made;
  statistics.patches.madeAgain = m_madeAgain;
  statistics.patches.dropped = m_dropped;
  statistics.memory.heights = m_heightBytes;
  statistics.memory.meshes = m_meshBytes;
  statistics.memory.maps = m_database.maps().residentBytes();
  statistics.memory.buffers = m_scene.drawing()->bufferBytes();
  statistics.memory.records = m_madeKeys.size() * 40;
}

std::uint64_t TeTerrain::hash() const {
  std::uint64_t hash = teMix(std::uint64_t(m_block.radius));
  m_block.forEach([&](const TePatchKey& key) {
    hash = teHashCombine(hash, std::uint64_t(key.x));
    hash = teHashCombine(hash, std::uint64_t(key.y));
    if (const TePatchData* patch = m_database.find(key); patch && patch->hasHeights())
      hash = teHashCombine(hash, teHashBytes(patch->heights().row(0), patch->heights().bytes()));
  });
  return hash;
}
