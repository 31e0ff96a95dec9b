#pragma once

#include "nodes/lod/LodViews.h"
#include "nodes/lod/TeWatertight.h"
#include "nodes/seamless/TeSeamlessTerrain.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <random>

/// Gives the triangles of a selection to `mesh`, which is cleared.
inline void meshOf(const TeSeamlessSelection& selection, const TeSeamlessLayout& layout,
                   const TeSeamlessParts& parts, TeWatertight& mesh) {
  mesh.clear();
  for (const TeSeamlessPatch& patch : selection.patches) {
    const int cellsLog = layout.cellsLog(patch.level), partLog = layout.maxResolutionLog();
    const auto add = [&](const TePart& part) {
      const auto vertex = [&](int index) {
        const TePartVertex& v =
            parts.vertices()[std::size_t(part.firstVertex) + parts.indices()[std::size_t(index)]];
        const int row = (patch.y << cellsLog) + ((v.y << cellsLog) >> partLog);
        const int column = (patch.x << cellsLog) + ((v.x << cellsLog) >> partLog);
        return std::uint32_t(row * (layout.resolution() + 1) + column);
      };
      for (int i = part.firstIndex; i < part.firstIndex + part.count; i += 3)
        mesh.add(vertex(i), vertex(i + 1), vertex(i + 2));
    };
    for (int side = 0; side < 4; side++) {
      add(parts.tile(side, patch.resolution(side)));
      add(parts.strip(side, patch.resolution(side), patch.resolution((side + 1) % 4)));
    }
  }
}

/// Windows as a clipmap may have them: around the eye or left behind, some levels missing.
template <class Random>
TeClipResidency anyResidency(Random& random, const TeSeamlessLayout& layout, int windowLog,
                             glm::dvec2 centre) {
  TeClipResidency residency;
  residency.base = windowLog;
  residency.windows.push_back({0, 0, (1 << windowLog) + 1});
  for (int level = windowLog + 1; level <= layout.resolutionLog(); level++) {
    const int samples = 1 << level;
    const int side = (1 << windowLog) + 1;
    const auto place = [&](double middle) {
      const int moved = int(random() % 3 == 0 ? random() % std::uint32_t(side) : 0) - side / 2;
      return std::clamp(int(middle * samples / layout.resolution()) + moved, 0, samples - side + 1);
    };
    TeClipWindow window{place(centre.x), place(centre.y), side};
    if (random() % 12 == 0)
      window.side = 0;
    residency.windows.push_back(window);
  }
  return residency;
}
