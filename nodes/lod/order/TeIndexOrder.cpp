#include "nodes/lod/order/TeIndexOrder.h"

#include "nodes/lod/order/TeHilbertOrder.h"
#include "nodes/lod/order/TeObliviousOrder.h"
#include "nodes/lod/order/TeTriangleStrips.h"

#ifdef TERRANE_HAVE_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace {

using Indices = std::vector<std::uint32_t>;

Indices inOrder(const std::vector<std::int32_t>& order, const Indices& indices) {
  Indices ordered;
  ordered.reserve(indices.size());
  for (const std::int32_t triangle : order)
    for (std::size_t corner = 0; corner < 3; corner++)
      ordered.push_back(indices[3 * std::size_t(triangle) + corner]);
  return ordered;
}

TeResult<Indices> forVertexCache(std::size_t vertices, const Indices& indices) {
#ifdef TERRANE_HAVE_MESHOPTIMIZER
  Indices ordered(indices.size());
  if (!indices.empty())
    meshopt_optimizeVertexCache(ordered.data(), indices.data(), indices.size(), vertices);
  return ordered;
#else
  (void)vertices;
  (void)indices;
  return TeError{"the index order 'vertex-cache' needs meshoptimizer, which Terrane was built without"};
#endif
}

} // namespace

const std::vector<TeIndexOrder::Kind>& TeIndexOrder::all() {
  static const std::vector<Kind> kinds = {Kind::AsMade,  Kind::Strips,    Kind::CacheAware,
                                          Kind::Hilbert, Kind::Oblivious, Kind::VertexCache};
  return kinds;
}

std::string TeIndexOrder::name(Kind kind) {
  switch (kind) {
  case Kind::AsMade:
    return "as-made";
  case Kind::Strips:
    return "strips";
  case Kind::CacheAware:
    return "cache-aware";
  case Kind::Hilbert:
    return "hilbert";
  case Kind::Oblivious:
    return "oblivious";
  case Kind::VertexCache:
    return "vertex-cache";
  }
  return {};
}

TeResult<Indices> TeIndexOrder::apply(Kind kind, const std::vector<TeLodVertex>& vertices,
                                      const Indices& indices) {
  switch (kind) {
  case Kind::AsMade:
    break;
  case Kind::Strips:
    return TeTriangleStrips::create(indices).triangles(indices);
  case Kind::CacheAware:
    return TeTriangleStrips::create(indices, kCacheStrip)
        .orderedForCache(indices, vertices.size(), kCacheSize)
        .triangles(indices);
  case Kind::Hilbert:
    return inOrder(TeHilbertOrder::create(vertices, indices), indices);
  case Kind::Oblivious:
    return inOrder(TeObliviousOrder::create(indices), indices);
  case Kind::VertexCache:
    return forVertexCache(vertices.size(), indices);
  }
  return indices;
}
