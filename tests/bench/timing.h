#pragma once

#include "generators/base/TeAllowance.h"
#include "nodes/lod/TeLodMesh.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The least CPU time of some runs.
template <class Work> double leastSeconds(int runs, Work work) {
  double least = 1e9;
  for (int run = 0; run < runs; run++) {
    const double start = teThreadCpuSeconds();
    work();
    least = std::min(least, teThreadCpuSeconds() - start);
  }
  return least;
}

inline double median(std::vector<double>& values) {
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Nanoseconds a triangle to copy as many indices, and their vertices, one by one.
inline double plainWriting(const TeLodMesh& mesh) {
  TeLodMesh copy;
  const double seconds = leastSeconds(9, [&] {
    copy.clear();
    for (const TeLodVertex& vertex : mesh.vertices)
      copy.vertices.push_back(vertex);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      copy.indices.insert(copy.indices.end(), {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    benchmark::DoNotOptimize(copy.indices.data());
  });
  return 1e9 * seconds / double(std::max<std::int64_t>(1, mesh.triangles()));
}
