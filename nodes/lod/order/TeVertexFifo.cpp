#include "nodes/lod/order/TeVertexFifo.h"

double TeVertexFifo::missesPerTriangle(const std::vector<std::uint32_t>& indices, std::size_t vertices,
                                       int size) {
  TeVertexFifo cache(vertices, size);
  for (const std::uint32_t vertex : indices)
    cache.use(vertex);
  return indices.empty() ? 0 : double(cache.misses()) / (double(indices.size()) / 3);
}
