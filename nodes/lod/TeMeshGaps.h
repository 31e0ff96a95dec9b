#pragma once

#include "nodes/lod/TeLodField.h"
#include "nodes/lod/TeLodMesh.h"
#include "nodes/lod/TeLodView.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

/// Finds where the triangles of a LOD method leave gaps, as a view sees them, whether or not they share
/// vertices.
///
/// One thread at a time. Memory: 4 bytes a sample and 12 bytes an edge, used again. Cost: about 15 ns an
/// edge.
class TeMeshGaps {
public:
  /// The terrain has up to 32768 cells a side.
  explicit TeMeshGaps(TeLodFieldPtr field);

  /// Edges in view, not on the rim of the terrain, that are not shared by exactly two triangles with the same
  /// heights at both ends. Of a mesh with skirts only those that somewhere have a surface below them that
  /// their skirt does not reach down to; or none beside them, as nothing of it is in view, and a skirt that
  /// does not reach down to the samples. (Whether samples in view are covered, TeScreenError tells.)
  std::int64_t count(const TeLodMesh& mesh, const TeLodView& view);

private:
  /// An edge from the sample in whose list it is to one with a greater number; heights bit for bit.
  struct Edge {
    std::uint32_t to = 0;
    float fromHeight = 0;
    float toHeight = 0;
  };
  struct Open {
    std::uint32_t from = 0;
    Edge edge;
  };
  /// A vertical wall between two samples.
  struct Wall {
    double area = 0; ///< sums of its triangles' vertical sides
    float fromLowest = 0;
    float toLowest = 0;
  };

  /// Open edges at a sample.
  struct Beside {
    double lowest = 0;
    int edges = 0; ///< that go on from there
  };

  void sortEdges(const TeLodMesh& mesh);
  bool onRim(std::uint32_t from, std::uint32_t to) const;
  bool inView(const Open& open, const TeLodView& view) const;
  void gatherWalls(const TeLodMesh& mesh);
  void gatherSurfaces();
  bool isHidden(const Open& open) const;
  template <class Visit> void alongEdge(const Open& open, const Visit& visit) const;

  TeLodFieldPtr m_field;
  std::uint32_t m_width; ///< samples a side
  std::vector<std::uint32_t> m_ends;
  std::vector<Edge> m_edges; ///< of sample i: from m_ends[i - 1] to m_ends[i] - 1
  std::vector<Open> m_open;
  std::unordered_map<std::uint64_t, Wall> m_walls;    ///< by both samples
  std::unordered_map<std::uint64_t, Beside> m_beside; ///< by sample and direction
};
