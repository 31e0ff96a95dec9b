#include "nodes/lod/seamless/TeSeamlessLod.h"

#include <algorithm>
#include <unordered_map>

TeResult<std::unique_ptr<TeLodMethod>> TeSeamlessLod::create(TeLodFieldPtr field, const Settings& settings) {
  const int minResolution = std::min(settings.minResolution, field->cells());
  const TeResult<TeSeamlessLayout> layout =
      TeSeamlessLayout::create(field->cells(), minResolution, settings.levels);
  if (!layout)
    return layout.error();
  TeResult<TeSeamlessTerrainPtr> terrain = TeSeamlessTerrain::create(*layout, field->sharedHeights());
  if (!terrain)
    return terrain.error();
  return std::unique_ptr<TeLodMethod>(new TeSeamlessLod(std::move(field), std::move(*terrain)));
}

TeSeamlessLod::TeSeamlessLod(TeLodFieldPtr shared, TeSeamlessTerrainPtr terrain)
    : TeLodMethod(std::move(shared)), m_terrain(std::move(terrain)) {
  m_placement.corner = field().placement().corner;
  m_placement.spacing = field().spacing();
  m_placement.heightScale = field().heightScale();
  m_placement.range = {field().lowest(), field().highest()};
}

const TeLodDial& TeSeamlessLod::dial() const {
  static const TeLodDial precision{"precision", true, 1, 1e6};
  return precision;
}

double TeSeamlessLod::bytesPerSample() const {
  const TeSeamlessLayout& layout = m_terrain->layout;
  const double samples = double(layout.resolution() + 1) * double(layout.resolution() + 1);
  const TeSeamlessParts& parts = *m_terrain->wholePatches();
  const double shared =
      double(parts.vertices().size() * sizeof(TePartVertex) + parts.indices().size() * sizeof(std::uint16_t));
  const double bounds = double(layout.patchCount()) * (8.0 * (layout.levels() + 5) + 8.0);
  const double chosen = double(m_chosen.patches.capacity() * sizeof(TeSeamlessPatch) +
                               m_lists.instances().capacity() * sizeof(TeSeamlessInstance));
  return sizeof(float) + (shared + bounds + chosen) / samples;
}

void TeSeamlessLod::choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance&,
                           TeLodSelection& selection) {
  TeSeamlessAccuracy wanted;
  wanted.pixelError = accuracy.dial > 0 ? 0 : accuracy.pixelError;
  wanted.exact = !(accuracy.dial > 0) && accuracy.pixelError == 0;
  wanted.precision = accuracy.dial > 0 ? accuracy.dial : 1;
  wanted.geomorph = accuracy.geomorph;
  // A patch has four tiles of a triangle a side at least, and its strips.
  const std::int64_t least = 4 * std::int64_t(m_terrain->layout.minResolution());
  wanted.maxPatches = int(std::clamp<std::int64_t>(accuracy.maxTriangles / least, 1, 1 << 24));
  m_terrain->selector.select(view, m_placement, wanted, nullptr, m_chosen);
  m_lists.build(m_chosen, m_terrain->layout, *m_terrain->wholePatches());

  for (const TeSeamlessPatch& patch : m_chosen.patches)
    selection.parts.push_back({keyOf(patch), trianglesOf(patch)});
  selection.triangles = m_chosen.triangles;
  selection.visited = m_chosen.traversed;
  selection.culled = m_chosen.culled;
  selection.errorBound = m_chosen.errorBound;
  selection.dial = accuracy.dial > 0 ? accuracy.dial : m_chosen.precision;
  selection.coarsening = m_chosen.coarsening;
}

std::int64_t TeSeamlessLod::trianglesOf(const TeSeamlessPatch& patch) const {
  const TeSeamlessParts& parts = *m_terrain->parts;
  std::int64_t indices = 0;
  for (int side = 0; side < 4; side++)
    indices += parts.tile(side, patch.resolution(side)).count +
               parts.strip(side, patch.resolution(side), patch.resolution((side + 1) % 4)).count;
  return indices / 3;
}

std::uint64_t TeSeamlessLod::keyOf(const TeSeamlessPatch& patch) {
  constexpr std::uint64_t kMorphed = std::uint64_t(1) << 63;
  std::uint64_t resolutions = 0;
  for (int side = 0; side < 4; side++) {
    if (teDetailWeight(patch.detail[std::size_t(side)]) != 255)
      return kMorphed | m_morphedParts++;
    resolutions = resolutions << 4 | std::uint64_t(patch.resolution(side));
  }
  const TeSeamlessLayout& layout = m_terrain->layout;
  const std::int64_t number =
      layout.firstPatch(patch.level) + std::int64_t(patch.y) * layout.patchesPerSide(patch.level) + patch.x;
  return std::uint64_t(number) << 16 | resolutions;
}

void TeSeamlessLod::appendPart(std::size_t part, TeLodMesh& mesh) const {
  const TeSeamlessMapHeights heights(&field().heights());
  std::vector<TeSeamlessMesh::Triangle> triangles;
  TeSeamlessMesh::appendPatch(m_chosen.patches[part], m_terrain->layout, *m_terrain->parts, heights,
                              triangles);
  std::unordered_map<std::int64_t, std::uint32_t> numbers;
  for (const TeSeamlessMesh::Triangle& triangle : triangles)
    for (const TeLodVertex& vertex : {triangle.a, triangle.b, triangle.c}) {
      const auto [found, isNew] = numbers.try_emplace(std::int64_t(vertex.row) << 32 | vertex.column,
                                                      std::uint32_t(mesh.vertices.size()));
      if (isNew)
        mesh.vertices.push_back(vertex);
      mesh.indices.push_back(found->second);
    }
}
