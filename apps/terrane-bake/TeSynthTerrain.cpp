#include "apps/terrane-bake/TeSynthTerrain.h"

#include "generators/base/TeFloatEnvironment.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kShare = 0.25; ///< of the roughness: the most that noise adds or takes

/// Octaves from the base's spacing down to wavelengths of two samples.
int octavesBetween(double longest, double sample) {
  int octaves = 1;
  while (octaves < TeNoiseSettings::kMaxOctaves && longest / double(1 << octaves) >= 2 * sample)
    ++octaves;
  return octaves;
}

TeNoisePlan detailPlan(double baseSpacing, double spacing, int octaves, std::uint64_t seed) {
  TeNoiseSettings settings;
  settings.type = TeNoiseType::Fbm;
  settings.wavelength = baseSpacing;
  settings.octaves = octaves;
  settings.amplitude = kShare;
  settings.seed = 4;
  return TeNoisePlan(settings, seed, spacing);
}

} // namespace

TeSynthTerrain::TeSynthTerrain(TeSynthBase base, int side, std::uint64_t seed)
    : m_base(std::move(base)), m_side(side),
      m_octaves(octavesBetween(TeSynthBase::kExtent / (m_base.side - 1), TeSynthBase::kExtent / (side - 1))),
      m_plan(detailPlan(TeSynthBase::kExtent / (m_base.side - 1), TeSynthBase::kExtent / (side - 1),
                        m_octaves, seed)),
      m_line(std::size_t(m_base.side) + 3), m_roughLine(std::size_t(m_base.side) + 1),
      m_noise(std::size_t(side)) {
  const TeFloatEnvironment environment;
  measureRoughness();
  for (int column = 0; column < side; ++column)
    m_places.push_back(place(column));
}

int TeSynthTerrain::inside(int post) const { return std::clamp(post, 0, m_base.side - 1); }

TeSynthTerrain::Place TeSynthTerrain::place(int index) const {
  Place place;
  const std::int64_t steps = std::int64_t(index) * (m_base.side - 1);
  place.post = int(steps / (m_side - 1));
  const double t = double(steps % (m_side - 1)) / (m_side - 1);
  place.fraction = t;
  place.weights[0] = 0.5 * t * (-1 + t * (2 - t));
  place.weights[1] = 1 + 0.5 * t * t * (-5 + 3 * t);
  place.weights[2] = 0.5 * t * (1 + t * (4 - 3 * t));
  place.weights[3] = 0.5 * t * t * (t - 1);
  return place;
}

void TeSynthTerrain::measureRoughness() {
  m_roughness.reserve(m_base.heights.size());
  for (int y = 0; y < m_base.side; ++y)
    for (int x = 0; x < m_base.side; ++x) {
      float low = m_base.at(x, y);
      float high = low;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
          low = std::min(low, m_base.at(inside(x + i), inside(y + j)));
          high = std::max(high, m_base.at(inside(x + i), inside(y + j)));
        }
      m_roughness.push_back(high - low);
    }
}

void TeSynthTerrain::row(int row, std::uint16_t* heights) {
  const TeFloatEnvironment environment;
  const Place down = place(row);
  const std::size_t side = std::size_t(m_base.side);
  for (int x = -1; x <= m_base.side + 1; ++x) {
    double& height = m_line[std::size_t(x + 1)];
    height = 0;
    for (int j = 0; j < 4; ++j)
      height += down.weights[j] * double(m_base.at(inside(x), inside(down.post - 1 + j)));
  }
  const float* const north = &m_roughness[side * std::size_t(down.post)];
  const float* const south = &m_roughness[side * std::size_t(inside(down.post + 1))];
  for (std::size_t x = 0; x <= side; ++x) {
    const std::size_t post = std::min(x, side - 1);
    m_roughLine[x] = (1 - down.fraction) * double(north[post]) + down.fraction * double(south[post]);
  }
  TeNoiseKernel::best().row(m_plan, 0, 2 * std::int64_t(m_side - 1 - row), m_side, m_noise.data());

  const double sea = double(m_base.sea);
  for (int column = 0; column < m_side; ++column) {
    const Place& across = m_places[std::size_t(column)];
    const double* const line = &m_line[std::size_t(across.post)];
    const double* const rough = &m_roughLine[std::size_t(across.post)];
    const double large = across.weights[0] * line[0] + across.weights[1] * line[1] +
                         across.weights[2] * line[2] + across.weights[3] * line[3];
    const double roughness = (1 - across.fraction) * rough[0] + across.fraction * rough[1];
    const double height = large + roughness * double(m_noise[std::size_t(column)]);
    heights[column] = std::uint16_t(std::floor(std::clamp(height, sea, 65535.0) + 0.5));
  }
}
