#pragma once

#include "patchdb/TeHeightBlocks.h"
#include "patchdb/TePatchMesh.h"
#include "patchdb/TeSourceMap.h"

#include <array>
#include <memory>

using TePatchMeshPtr = std::shared_ptr<const TePatchMesh>;

/// What is known of one patch: its source maps (shared by four patches), its heights, its neighbours, and the
/// seams around it (shared by the patches that meet there). Records are made and linked by the tree; the
/// database fills them.
class TePatchData {
public:
  explicit TePatchData(const TePatchKey& key) : m_key(key) {}
  /// Takes itself out of its neighbours, and its seams with it.
  ~TePatchData();
  TePatchData(const TePatchData&) = delete;
  TePatchData& operator=(const TePatchData&) = delete;

  const TePatchKey& key() const { return m_key; }

  /// Source maps: 0 = centred on the south-west corner of the patch, 1 = south-east, 2 = north-west,
  /// 3 = north-east. Null before prepareBuildMaps() and after dropMaps(), and those that are not needed (see
  /// TeNeededMaps).
  const TeSourceMapPtr& map(int corner) const { return m_maps[std::size_t(corner)]; }
  const TePatchMaps& maps() const { return m_maps; }
  /// True if all maps that the heights are made from are there.
  bool hasMaps() const { return m_hasMaps; }
  /// All maps that are needed.
  void setMaps(TePatchMaps maps) {
    m_maps = std::move(maps);
    m_hasMaps = true;
  }
  void dropMaps() {
    m_maps = {};
    m_hasMaps = false;
  }

  bool hasHeights() const { return !m_heights.empty(); }
  /// (n+1)×(n+1) samples; sample (0, 0) is the south-west corner. Empty before buildHeights().
  const TeHeightMap& heights() const { return m_heights; }
  /// Replaces the heights; samples that are not finite become missing. `deviation`: how far, in metres, the
  /// surface of the base level may lie from this patch's surface (0 at the base level). Drops the seams. If
  /// memory runs out it throws and is as before.
  void setHeights(TeHeightMap heights, float deviation = 0);
  void dropHeights();
  /// Of the samples that are not missing; both 0 if all are.
  float minimum() const { return m_minimum; }
  float maximum() const { return m_maximum; }
  bool hasMissing() const { return m_missing > 0; }
  float deviation() const { return m_deviation; }
  /// Lowest and highest heights of parts.
  const TeHeightBlocks& blocks() const { return m_blocks; }
  /// Of the record, its heights and their blocks; without source maps and seams, which patches share.
  std::size_t bytes() const { return sizeof(*this) + m_heights.bytes() + m_blocks.bytes(); }

  /// Null if that patch is not known.
  TePatchData* neighbour(TeDirection direction) { return m_neighbours[std::size_t(direction)]; }
  const TePatchData* neighbour(TeDirection direction) const { return m_neighbours[std::size_t(direction)]; }

  /// The seam or corner square in a direction, if it was made.
  const TePatchMeshPtr& seam(TeDirection direction) const { return m_seams[std::size_t(direction)]; }
  /// Gives a seam to this patch and to all others that meet there.
  void shareSeam(TeDirection direction, const TePatchMeshPtr& seam);

  /// Makes two patches neighbours of each other.
  static void link(TePatchData& patch, TeDirection direction, TePatchData& other);

private:
  void dropSeams();

  TePatchKey m_key; // with the heights in one cache line, for point queries
  TeHeightMap m_heights;
  TePatchMaps m_maps;
  bool m_hasMaps = false;
  TeHeightBlocks m_blocks;
  float m_minimum = 0;
  float m_maximum = 0;
  float m_deviation = 0;
  std::int64_t m_missing = 0;
  std::array<TePatchData*, 8> m_neighbours = {};
  std::array<TePatchMeshPtr, 8> m_seams;
};
