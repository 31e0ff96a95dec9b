#pragma once

#include "apps/terrane-accuracy/TeMeasuredTerrain.h"
#include "patchdb/TePatchDatabase.h"

#include <functional>
#include <memory>

/// A measured terrain as a patch database with coarse levels: what queries are asked of.
class TeHeightWorld {
public:
  static constexpr int kCells = 32; ///< a side of a patch

  /// `levels`: 1 .. the logarithm of the terrain's patches a side + 1; as many as fit are made. `progress` is
  /// told 0 .. 1. Error: no memory, or a terrain of less than one patch.
  static TeResult<TeHeightWorld> create(const TeMeasuredTerrain& terrain, int levels,
                                        const std::function<void(double)>& progress);

  const TePatchDatabase& database() const { return *m_database; }
  int levels() const { return m_levels; }
  double side() const { return m_side; } ///< metres
  /// World coordinate of a place so many metres east or north of the terrain's south-west corner.
  double at(double offset) const { return m_corner + offset; }
  /// Of the patches of a level, their records, blocks and tree, for one sample of the terrain.
  double bytesPerSample(int level) const;
  /// Largest deviation of a level's patches, metres.
  double worstDeviation(int level) const;

private:
  explicit TeHeightWorld(std::unique_ptr<TePatchDatabase> database) : m_database(std::move(database)) {}

  std::unique_ptr<TePatchDatabase> m_database;
  int m_levels = 1;
  double m_side = 0;
  double m_corner = 0;
  std::int64_t m_samples = 0;
};
