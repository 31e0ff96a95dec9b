#pragma once

#include "generators/base/TeHash.h"
#include "patchdb/TePatchDatabase.h"

#include <cmath>
#include <functional>

/// Heights between -amplitude and amplitude that differ from map to map and from sample to sample: the
/// hardest input for blending, since nothing fits by itself.
class TeHashSource final : public TePointSource {
public:
  explicit TeHashSource(std::uint64_t salt = 1, float amplitude = 100.0f)
      : m_salt(salt), m_amplitude(amplitude) {}
  std::string name() const override { return "hash"; }
  std::uint64_t fingerprint() const override { return teHashCombine(m_salt, std::uint64_t(m_amplitude)); }
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override {
    const std::uint64_t map = teHashCombine(teHashCombine(m_salt, std::uint64_t(request.key.x)),
                                            std::uint64_t(request.key.y) + request.worldSeed);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t bits =
          teHashCombine(map, (std::uint64_t(samples[i].column) << 32) + std::uint64_t(samples[i].row));
      heights[i] = m_amplitude * (float(bits >> 40) * 0x1p-23f - 1.0f);
    }
    return {};
  }

private:
  std::uint64_t m_salt;
  float m_amplitude;
};

/// A fitting landscape: a function of the global sample.
class TeSampleSource final : public TePointSource {
public:
  using Function = std::function<float(std::int64_t x, std::int64_t y)>;
  explicit TeSampleSource(Function function) : m_function(std::move(function)) {}
  std::string name() const override { return "sample"; }
  std::uint64_t fingerprint() const override { return std::uint64_t(reinterpret_cast<std::uintptr_t>(this)); }
  bool fits() const override { return true; }
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override {
    for (std::size_t i = 0; i < count; ++i)
      heights[i] = m_function(request.globalX(samples[i].column), request.globalY(samples[i].row));
    return {};
  }

private:
  Function m_function;
};

/// Different sources in a chequered pattern of maps.
class TeChequeredSources final : public TeSourceChooser {
public:
  explicit TeChequeredSources(std::vector<TeHeightSourcePtr> sources) : m_sources(std::move(sources)) {}
  TeHeightSourcePtr choose(const TeMapKey& key) const override {
    return m_sources[(std::uint64_t(key.x) + 3 * std::uint64_t(key.y)) % m_sources.size()];
  }
  bool fits() const override { return false; }
  bool pointEvaluable() const override { return false; }

private:
  std::vector<TeHeightSourcePtr> m_sources;
};

inline std::unique_ptr<TePatchDatabase> teTestDatabase(std::shared_ptr<const TeSourceChooser> sources,
                                                       int samples, double spacing = 1.0,
                                                       std::uint64_t seed = 7) {
  return std::move(
      *TePatchDatabase::create({*TeLattice::create(samples, spacing), seed, std::move(sources)}));
}

inline std::unique_ptr<TePatchDatabase> teTestDatabase(TeHeightSourcePtr source, int samples,
                                                       double spacing = 1.0) {
  return teTestDatabase(std::make_shared<TeSingleSource>(std::move(source)), samples, spacing);
}

/// A fitting landscape whose heights are given by a function of the global sample.
inline std::unique_ptr<TePatchDatabase> teSampleWorld(TeSampleSource::Function function, int samples,
                                                      double spacing = 1.0) {
  return teTestDatabase(std::make_shared<TeSampleSource>(std::move(function)), samples, spacing);
}
