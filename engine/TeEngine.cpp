#include "engine/TeEngine.h"

#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeLog.h"

#include <Inventor/SoDB.h>

#include <cmath>

namespace {

TeResult<TeLattice> latticeOf(const SbVec2s& samples, const SbVec2f& area) {
  const std::string given = std::to_string(samples[0]) + "×" + std::to_string(samples[1]);
  if (samples[0] != samples[1])
    return TeError{"TeEngine: source maps of " + given + " samples: both sides must be equal"};
  if (!(area[0] == area[1]))
    return TeError{"TeEngine: area of " + std::to_string(area[0]) + " by " + std::to_string(area[1]) +
                   " m: both sides must be equal numbers"};
  if (samples[0] < TeLattice::kMinSamples)
    return TeError{"TeEngine: source maps of " + given + " samples: at least " +
                   std::to_string(TeLattice::kMinSamples) + " a side"};
  return TeLattice::create(samples[0], double(area[0]) / (samples[0] - 1));
}

} // namespace

TeEngine::TeEngine(const SbVec2s& samples, const SbVec2f& area) {
  const TeResult<TeLattice> lattice = latticeOf(samples, area);
  if (!lattice) {
    fail(lattice.error());
    return;
  }
  m_lattice = *lattice;
  m_usable = true;
  setGenerator(TeGeneratorRegistry::kDefaultGenerator);
}

TeEngine::~TeEngine() = default;

SbBool TeEngine::fail(const TeError& error) {
  m_lastError = error.message;
  TeLog::error(error.message);
  return FALSE;
}

SbBool TeEngine::setSeed(std::uint64_t seed) {
  if (!m_patches.empty())
    return fail({"TeEngine: the seed cannot change once there are patches"});
  m_seed = seed;
  return isValid() ? createDatabase() : FALSE;
}

SbBool TeEngine::setBlending(TeBlendProfile profile) {
  if (!m_patches.empty())
    return fail({"TeEngine: the blending cannot change once there are patches"});
  m_blending = profile;
  return isValid() ? createDatabase() : FALSE;
}

SbBool TeEngine::setGenerator(const std::string& specification, const std::vector<std::string>& filters) {
  TeResult<std::unique_ptr<TeGenerator>> made = TeGeneratorRegistry::instance().chain(specification, filters);
  return made ? setGenerator(std::move(*made)) : fail(made.error());
}

SbBool TeEngine::setGenerator(std::unique_ptr<TeGenerator> generator) {
  if (!m_usable)
    return FALSE;
  if (!generator)
    return fail({"TeEngine: no generator given"});
  if (const TeStatus ok = generator->updateParams(); !ok)
    return fail(ok.error());
  if (const TeStatus ok = generator->source()->accepts(m_lattice.samples(), m_lattice.samples()); !ok)
    return fail(ok.error());
  m_generator = std::move(generator);
  return m_database ? updateParams() : createDatabase();
}

SbBool TeEngine::updateParams() {
  if (const TeStatus ok = m_generator->updateParams(); !ok)
    return fail(ok.error());
  const TeHeightSourcePtr source = m_generator->source();
  if (source->fingerprint() == m_source->fingerprint())
    return TRUE;
  if (const TeStatus ok = m_database->setSources(std::make_shared<TeSingleSource>(source)); !ok)
    return fail(ok.error());
  m_source = source;
  return TRUE;
}

SbBool TeEngine::createDatabase() {
  m_source = m_generator->source();
  auto made =
      TePatchDatabase::create({m_lattice, m_seed, std::make_shared<TeSingleSource>(m_source), m_blending});
  if (!made)
    return fail(made.error());
  m_database = std::move(*made);
  return TRUE;
}

TePatch* TeEngine::getPatch(const SbVec2f& point) { return getPatch(SbVec2d(point[0], point[1])); }

TePatch* TeEngine::getPatch(const SbVec2d& point) {
  if (!isValid())
    return nullptr;
  const TeResult<TePatchKey> key = tePatchAt(m_lattice, {point[0], point[1]});
  if (!key) {
    fail(key.error());
    return nullptr;
  }
  return getPatch(*key);
}

TePatch* TeEngine::getPatch(const TePatchKey& key) {
  if (!isValid())
    return nullptr;
  if (const auto found = m_patches.find(key); found != m_patches.end())
    return found->second.get();
  if (key.level != 0) {
    fail({"patch " + key.text() + ": TeEngine makes patches of level 0"});
    return nullptr;
  }
  const TeResult<TePatchData*> data = m_database->lookup(key, TeLookup::Create);
  if (!data) {
    fail(data.error());
    return nullptr;
  }
  return m_patches.emplace(key, std::unique_ptr<TePatch>(new TePatch(*this, **data))).first->second.get();
}

SbBool TeEngine::setOrigin(const SbVec2d& point) {
  if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
    return fail({"TeEngine: the origin must be finite"});
  m_origin = point;
  if (m_graphs)
    m_graphs->setWorldOrigin({point[0], point[1], 0});
  return TRUE;
}

TePatchGraphBuilder* TeEngine::getGraphBuilder() {
  if (!isValid())
    return nullptr;
  if (!SoDB::isInitialized()) {
    fail({"TeEngine: SoDB::init() has to come before graphs are made"});
    return nullptr;
  }
  if (!m_graphs)
    m_graphs = std::make_unique<TePatchGraphBuilder>(glm::dvec2(m_origin[0], m_origin[1]));
  return m_graphs.get();
}

TeNodePtr<SoSeparator> TeEngine::makeGraph(const TePatchMesh& mesh) {
  TePatchGraphBuilder* builder = getGraphBuilder();
  return builder ? builder->build(mesh) : nullptr;
}
