#include "nodes/lod/TeLodMethods.h"

#include "nodes/lod/brute/TeBruteForce.h"
#include "nodes/lod/chunked/TeChunkedLod.h"
#include "nodes/lod/geomipmap/TeGeoMipMapping.h"
#include "nodes/lod/quadtree/TeQuadtreeLod.h"
#include "nodes/lod/roam/TeRoamLod.h"
#include "nodes/lod/rtin/TeRtinLod.h"
#include "nodes/lod/seamless/TeSeamlessLod.h"

#include <algorithm>

namespace {

using Made = TeResult<std::unique_ptr<TeLodMethod>>;

struct Entry {
  std::string name;
  Made (*create)(TeLodFieldPtr field);
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      {"brute",
       [](TeLodFieldPtr field) -> Made { return {std::make_unique<TeBruteForce>(std::move(field))}; }},
      {"roam", [](TeLodFieldPtr field) -> Made { return {TeRoamLod::create(std::move(field))}; }},
      {"quadtree", [](TeLodFieldPtr field) -> Made { return TeQuadtreeLod::create(std::move(field)); }},
      {"seamless", [](TeLodFieldPtr field) -> Made { return TeSeamlessLod::create(std::move(field)); }},
      {"geomipmap", [](TeLodFieldPtr field) -> Made { return TeGeoMipMapping::create(std::move(field)); }},
      {"chunked", [](TeLodFieldPtr field) -> Made { return TeChunkedLod::create(std::move(field)); }},
      {"rtin",
       [](TeLodFieldPtr field) -> Made {
         return {std::make_unique<TeRtinLod>(std::move(field), TeRtinError::Exact)};
       }},
      {"rtin-midpoint",
       [](TeLodFieldPtr field) -> Made {
         return {std::make_unique<TeRtinLod>(std::move(field), TeRtinError::Midpoint)};
       }},
  };
  return all;
}

} // namespace

const std::vector<std::string>& TeLodMethods::names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> names;
    for (const Entry& entry : entries())
      names.push_back(entry.name);
    return names;
  }();
  return names;
}

TeResult<std::unique_ptr<TeLodMethod>> TeLodMethods::create(const std::string& name, TeLodFieldPtr field) {
  std::string known;
  for (const Entry& entry : entries()) {
    if (entry.name == name)
      return entry.create(std::move(field));
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  return TeError{"'" + name + "' is no LOD method: " + known};
}
