#pragma once

#include "nodes/seamless/TeSeamlessMesh.h"
#include "nodes/seamless/TeSeamlessSelector.h"

#include <memory>
#include <mutex>

/// What Seamless Patches draw, as far as it does not depend on where it lies or who looks at it. Immutable,
/// thread-safe.
struct TeSeamlessTerrain {
  TeSeamlessLayout layout;
  std::shared_ptr<const TeSeamlessParts> parts;
  TeSeamlessSelector selector;
  /// Heights of all samples; null if the terrain is flat, or its heights come from clipmaps.
  std::shared_ptr<const TeHeightMap> map;
  /// Of all samples.
  TeHeightRange range;

  /// The parts with whole patches, made when first asked for; without these if they do not fit.
  const std::shared_ptr<const TeSeamlessParts>& wholePatches() const;

  /// All heights 0.
  static std::shared_ptr<const TeSeamlessTerrain> flat(const TeSeamlessLayout& layout);
  /// Errors of TeSeamlessBounds::create().
  static TeResult<std::shared_ptr<const TeSeamlessTerrain>> create(const TeSeamlessLayout& layout,
                                                                   std::shared_ptr<const TeHeightMap> map);
  /// Of clipmaps: `bounds` may be null; then all heights lie in `range`.
  static std::shared_ptr<const TeSeamlessTerrain>
  create(const TeSeamlessLayout& layout, std::shared_ptr<const TeSeamlessBounds> bounds, TeHeightRange range);

private:
  TeSeamlessTerrain(const TeSeamlessLayout& layout, std::shared_ptr<const TeSeamlessBounds> bounds)
      : layout(layout), parts(std::make_shared<const TeSeamlessParts>(layout)),
        selector(layout, std::move(bounds)) {}

  mutable std::once_flag m_wholePatchesOnce;
  mutable std::shared_ptr<const TeSeamlessParts> m_wholePatches;
};

using TeSeamlessTerrainPtr = std::shared_ptr<const TeSeamlessTerrain>;

/// Heights of a map; of flat terrain without one. The map must outlive it.
class TeSeamlessMapHeights final : public TeSeamlessHeights {
public:
  explicit TeSeamlessMapHeights(const TeHeightMap* map) : m_map(map) {}
  float height(std::int32_t column, std::int32_t row, int) const override {
    return m_map ? m_map->at(column, row) : 0.0f;
  }

private:
  const TeHeightMap* m_map;
};
