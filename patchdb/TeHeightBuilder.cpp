#include "patchdb/TeHeightBuilder.h"

TeResult<std::unique_ptr<TeHeightBuilder>> TeHeightBuilder::create(const TePatchMaps& maps,
                                                                   const TeBlendWeights& weights) {
  const int cells = weights.cells();
  TeResult<TeHeightMap> heights = TeHeightMap::create(cells + 1, cells + 1);
  if (!heights)
    return heights.error();
  std::unique_ptr<TeHeightBuilder> builder(new TeHeightBuilder);
  builder->m_maps = maps;
  builder->m_heights = std::move(*heights);
  if (maps[0] && maps[1] && maps[2] && maps[3])
    builder->m_blend.emplace(weights, maps[0]->heights, maps[1]->heights, maps[2]->heights, maps[3]->heights,
                             builder->m_heights);
  return builder;
}

bool TeHeightBuilder::step(TeAllowance& allowance) {
  if (m_blend)
    return m_blend->step(allowance);
  const int side = m_heights.width();
  for (int corner = 0; corner < 4; ++corner)
    if (m_maps[std::size_t(corner)]) {
      const int x = corner % 2 == 0 ? side - 1 : 0;
      const int y = corner / 2 == 0 ? side - 1 : 0;
      [[maybe_unused]] const TeStatus ok =
          m_heights.copy(m_maps[std::size_t(corner)]->heights, {x, y, side, side}, m_heights.bounds());
      assert(ok);
    }
  allowance.spend();
  return true;
}
