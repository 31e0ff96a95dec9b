#include "nodes/lod/brute/TeBruteForce.h"

#include <algorithm>

TeBruteForce::TeBruteForce(TeLodFieldPtr shared)
    : TeLodMethod(std::move(shared)), m_patchCells(std::min(kPatchCells, field().cells())),
      m_patches(field().cells() / m_patchCells), m_ranges(std::size_t(m_patches) * std::size_t(m_patches)) {
  for (int y = 0; y < m_patches; y++)
    for (int x = 0; x < m_patches; x++) {
      const TeMapRect rect{x * m_patchCells, y * m_patchCells, m_patchCells + 1, m_patchCells + 1};
      const TeMapStatistics statistics = field().heights().statistics(rect).value();
      m_ranges[std::size_t(y * m_patches + x)] = {statistics.minimum, statistics.maximum};
    }
}

const TeLodDial& TeBruteForce::dial() const {
  static const TeLodDial none;
  return none;
}

double TeBruteForce::bytesPerSample() const {
  const double samples = double(field().cells() + 1) * double(field().cells() + 1);
  return sizeof(float) + double(m_ranges.size() * sizeof(Range)) / samples;
}

void TeBruteForce::choose(const TeLodView& view, const TeLodAccuracy&, TeAllowance&,
                          TeLodSelection& selection) {
  const std::int64_t triangles = 2 * std::int64_t(m_patchCells) * m_patchCells;
  for (int y = 0; y < m_patches; y++)
    for (int x = 0; x < m_patches; x++) {
      const std::size_t number = std::size_t(y * m_patches + x);
      const Range& range = m_ranges[number];
      selection.visited++;
      if (!view.meets(field().position(x * m_patchCells, y * m_patchCells, double(range.low)),
                      field().position((x + 1) * m_patchCells, (y + 1) * m_patchCells, double(range.high)))) {
        selection.culled++;
        continue;
      }
      selection.parts.push_back({number, triangles});
      selection.triangles += triangles;
    }
  selection.errorBound = 0;
}

void TeBruteForce::appendPart(std::size_t part, TeLodMesh& mesh) const {
  const int patch = int(selection().parts[part].key);
  const int x0 = patch % m_patches * m_patchCells;
  const int y0 = patch / m_patches * m_patchCells;
  const int width = m_patchCells + 1;
  const auto first = std::uint32_t(mesh.vertices.size());
  for (int y = 0; y < width; y++)
    for (int x = 0; x < width; x++)
      mesh.vertices.push_back(field().vertex(x0 + x, y0 + y));
  for (int y = 0; y < m_patchCells; y++)
    for (int x = 0; x < m_patchCells; x++) {
      const std::uint32_t southWest = first + std::uint32_t(y * width + x);
      const std::uint32_t northWest = southWest + std::uint32_t(width);
      mesh.indices.insert(mesh.indices.end(), {southWest, southWest + 1, northWest + 1});
      mesh.indices.insert(mesh.indices.end(), {southWest, northWest + 1, northWest});
    }
}
