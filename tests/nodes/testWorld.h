#pragma once

#include "generators/TeGeneratorRegistry.h"
#include "nodes/terrain/TeStaticBlock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

/// Heights given by a function of the global sample; not a number = missing.
class TeSampleFunction final : public TePointSource {
public:
  using Function = std::function<float(std::int64_t, std::int64_t)>;
  explicit TeSampleFunction(Function function) : m_function(std::move(function)) {}
  std::string name() const override { return "sample-function"; }
  std::uint64_t fingerprint() const override { return 1; }
  bool fits() const override { return true; }
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override {
    for (std::size_t i = 0; i < count; i++) {
      const float height = m_function(request.globalX(samples[i].column), request.globalY(samples[i].row));
      heights[i] = std::isnan(height) ? TeHeightMap::missing() : height;
    }
    return {};
  }

private:
  Function m_function;
};

inline TeWorld worldOf(TeHeightSourcePtr source, int samples, double spacing = 1, std::uint64_t seed = 0) {
  TeWorld world;
  world.lattice = *TeLattice::create(samples, spacing);
  world.seed = seed;
  world.sources = std::make_shared<TeSingleSource>(std::move(source));
  return world;
}

/// The world of a generator with filters, by specification.
inline TeWorld worldOf(const std::string& generator, const std::vector<std::string>& filters, int samples,
                       std::uint64_t seed) {
  const TeResult<TeHeightSourcePtr> source = TeGeneratorRegistry::instance().source(generator, filters);
  EXPECT_TRUE(source) << (source ? "" : source.error().message);
  return worldOf(source.value(), samples, 1, seed);
}
