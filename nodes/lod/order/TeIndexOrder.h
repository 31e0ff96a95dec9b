#pragma once

#include "generators/base/TeResult.h"
#include "nodes/lod/TeLodMesh.h"

#include <cstdint>
#include <string>
#include <vector>

/// Orders in which the triangles of a mesh are sent (docs/index-orders.md). All of them keep every triangle
/// and its winding; they differ in how often a vertex is transformed again, because a cache lost it.
class TeIndexOrder {
public:
  enum class Kind {
    AsMade,      ///< unchanged
    Strips,      ///< triangle strips, as long as can be (TeTriangleStrips)
    CacheAware,  ///< short strips, each next one that which a cache of kCacheSize vertices suits best
    Hilbert,     ///< along a Hilbert curve over columns and rows (TeHilbertOrder)
    Oblivious,   ///< halves of halves of the mesh, for any cache (TeObliviousOrder)
    VertexCache, ///< that of the library meshoptimizer, if Terrane was built with it
  };
  static constexpr int kCacheSize = 16;
  static constexpr std::int32_t kCacheStrip = 14; ///< triangles of a strip of CacheAware

  static const std::vector<Kind>& all();
  static std::string name(Kind kind); ///< as in options and tables: "cache-aware"

  /// The same triangles, three indices each, in another order. `indices` are of `vertices`, of which only
  /// columns and rows count, and those only for Hilbert.
  /// Error: VertexCache where meshoptimizer is missing.
  static TeResult<std::vector<std::uint32_t>> apply(Kind kind, const std::vector<TeLodVertex>& vertices,
                                                    const std::vector<std::uint32_t>& indices);
};
