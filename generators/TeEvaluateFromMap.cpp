#include "generators/TeEvaluateFromMap.h"

TeStatus teEvaluateFromMap(const TeHeightSource& source, const TeMapRequest& request,
                           const TeMapSample* samples, std::size_t count, float* heights) {
  const TeResult<TeHeightMap> map = source.generate(request);
  if (!map)
    return map.error();
  for (std::size_t i = 0; i < count; ++i)
    heights[i] = map->at(samples[i].column, samples[i].row);
  return {};
}
