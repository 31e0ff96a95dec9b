#pragma once

#include "nodes/lod/TeLodMesh.h"
#include "nodes/lod/quadtree/TeQuadtree.h"
#include "nodes/lod/quadtree/TeQuadtreeMetric.h"

#include <cmath>
#include <string>
#include <vector>

/// The mesh tree of the adaptive quadtree: what is displayed of a TeQuadtree, kept from frame to frame. A
/// square in it is *enabled*, and is drawn as a fan round its centre, over its corners and those middles of
/// its edges that are enabled, where no enabled child covers it.
///
/// Rules: an enabled square has the middles of its parent's two edges at it enabled; an enabled middle of an
/// edge has both squares at it enabled. A vertex counts the squares that have it for a corner, and goes only
/// when there are none. Of all meshes that keep the rules and pass the tests of a view, update() finds the
/// one with the fewest vertices, whatever was displayed before: the history decides what it costs, not what
/// is drawn.
///
/// Tests, for what is in view:
///  - `threshold`, the document's: vertex error · threshold > max-norm distance for middles of edges, largest
///    error inside · threshold > max-norm distance to its box for squares;
///  - `pixelError`: a triangle that is displayed is bisected if one of the two that its vertex would bisect
///    deviates, at any vertex of the data, by more pixels at the distance of a box around both.
///
/// One thread at a time; the data tree must outlive this, and may change between updates.
/// Cost of an update: in proportion to the displayed mesh, whatever the size of the data. No allocation once
/// it has been as large before. Memory: about 170 bytes a square and 36 a vertex of the displayed mesh.
class TeQuadtreeMesh {
public:
  struct Wish {
    double pixelError = 1; ///< not negative
    double threshold = 0;  ///< in place of pixelError if more than 0
    bool geomorph = false; ///< the true error is at most pixelError still
  };
  struct Result {
    std::int64_t triangles = 0; ///< of squares in view
    std::int64_t visited = 0;   ///< squares
    std::int64_t culled = 0;    ///< of those, not in view
    std::int64_t enabled = 0;   ///< vertices, in this update
    std::int64_t disabled = 0;
    double errorBound = 0; ///< pixels; no vertex of the data in view deviates by more
    bool changed = true;   ///< the triangles are not bit for bit those of the last update
  };

  TeQuadtreeMesh(const TeQuadtree& tree, const TeLodField::Placement& placement);

  const Result& update(const TeLodView& view, const Wish& wish);
  /// Forgets what was displayed.
  void clear();
  const Result& result() const { return m_result; }
  /// What is displayed, in squares of a kPartsPerSide-th of the terrain's side, and one part of all larger
  /// squares. The same key: the same triangles, bit for bit.
  struct Part {
    std::uint32_t place; ///< row · kPartsPerSide + column of the square; the number of these: larger squares
    std::int64_t triangles;
    std::uint64_t key;
  };
  static constexpr int kPartDepth = 4; ///< below the root
  static constexpr int kPartsPerSide = 1 << kPartDepth;
  const std::vector<Part>& parts() const { return m_parts; }

  /// Appends the triangles, with one vertex for each place.
  void append(TeLodMesh& mesh) const;
  void append(const Part& part, TeLodMesh& mesh) const;

  std::size_t bytes() const;
  /// What breaks the rules, a count or a link; empty if nothing does. For tests. Cost: a pass over the mesh.
  std::string inconsistency() const;

private:
  /// Share of pixelError that triangles may take while vertices are off by the rest, in motion.
  static constexpr double kMorphShare = 0.5;
  static constexpr double kMorphBand = 0.25; ///< a vertex has arrived at 1.25 times the error that enables it
  static constexpr int kCentre = 4;

  struct Vertex {
    std::int32_t column, row;
    float height;
    std::uint32_t users; ///< squares that have it for a corner
    float drawn;         ///< with geomorphing: between the middle of the edge that it splits, and height
    float weight;        ///< how far toward height
    std::uint32_t mark;  ///< frame of `weight`
  };
  /// An update looks at the first cache line of most squares only.
  struct alignas(64) Square {
    std::uint32_t mark; ///< frame in which it was last enabled
    std::uint32_t data;
    std::uint32_t children[4]; ///< 0: none
    std::uint32_t neighbours[4];
    std::uint32_t parent;
    std::int32_t x, y;
    std::uint8_t sideLog, quadrant;
    std::uint8_t planes; ///< that cut it, or kOutside
    std::uint8_t tested; ///< children that were, in this frame
    std::uint8_t edges;  ///< whose middles are enabled, in this frame

    std::uint32_t corners[4];  ///< vertices
    std::uint32_t vertices[5]; ///< middles of the edges, 0: none; centre
  };
  struct Drawn {
    std::int32_t x, y;
    std::uint32_t shape; ///< sideLog · 256 + bits 0..3: middles of edges that are enabled, 4..7: children
    std::uint32_t square;
    /// The same triangles; the record of the square may be another one.
    friend bool operator==(const Drawn& a, const Drawn& b) {
      return a.x == b.x && a.y == b.y && a.shape == b.shape;
    }
  };
  /// Of m_drawn.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0; ///< 0: nothing of the part is drawn
    std::uint64_t key = 0;
  };

  bool isMarked(std::uint32_t square) const { return square != 0 && m_squares[square].mark == m_frame; }
  std::uint32_t neighbourData(std::uint32_t number, int side) const;
  TeQuadtreeBox boxOf(const Square& square, std::uint32_t data) const;
  TeQuadtreeBox boxOfChild(const Square& square, int k, std::uint32_t data) const;
  TeQuadtreeBox boxOfEdge(const Square& square, int side, std::uint32_t neighbour) const;
  double edgeError(const Square& square, int side, std::uint32_t neighbour) const;
  bool inView(const Square& square, const TeQuadtreeBox& box) const;

  std::uint32_t makeVertex(std::int32_t column, std::int32_t row, float height);
  std::uint32_t makeSquare(std::uint32_t parent, int quadrant);
  std::uint32_t enableSquare(std::uint32_t parent, int quadrant);
  void enableEdge(std::uint32_t number, int side);
  void testEdge(std::uint32_t number, int side);
  void testChild(std::uint32_t number, int quadrant);
  bool isGoodEnough(double error, double x0, double x1, double y0, double y1) const;
  bool isTooFar(const Square& square, double error, const TeQuadtreeBox& box);
  void settle(std::uint32_t number);
  void removeSquare(std::uint32_t number);
  void removeEdge(std::uint32_t number, int side);
  void draw(std::uint32_t number);
  void drawTogether(bool isAnew);
  void beginAppend() const;
  void appendRange(std::size_t first, std::size_t count, TeLodMesh& mesh) const;
  void boundDrawn(std::uint32_t number, std::uint32_t enabled);
  /// What vertices may be off by while they move.
  double morphPixels() const { return std::sqrt(m_wanted2) * (1 / kMorphShare - 1); }
  float ownWeight(double error, const TeQuadtreeBox& box) const;
  float centreWeight(std::uint32_t number);
  float edgeWeight(std::uint32_t number, int side);
  void morphSquare(std::uint32_t number);
  void morphVertex(Vertex& vertex, float a, float b, const TeQuadtreeBox& box);

  const TeQuadtree* m_tree;
  TeLodField::Placement m_placement;
  std::vector<Vertex> m_vertices; ///< 0: none
  std::vector<Square> m_squares;  ///< 0: the root
  std::vector<std::uint32_t> m_freeVertices;
  std::vector<std::uint32_t> m_freeSquares;
  std::uint64_t m_heightsVersion = 0;

  // Of an update.
  std::uint32_t m_frame = 0;
  TeQuadtreeMetric m_metric;
  Wish m_wish;
  double m_wanted2 = 0;               ///< of triangles, pixels, squared
  double m_worst2 = 0;                ///< of those, pixels, squared
  double m_worstOffset = 0;           ///< of vertices in motion, pixels
  std::vector<std::uint32_t> m_tasks; ///< square · 8 + side whose middle was enabled, or kCentre
  std::vector<Drawn> m_drawn;
  std::vector<Drawn> m_lastDrawn;
  bool m_morphed = false;
  Result m_result;
  std::vector<Drawn> m_large; ///< squares that are no part of a part
  std::vector<Part> m_parts;
  std::vector<Range> m_ranges; ///< by Part::place
  std::vector<Range> m_lastRanges;
  std::uint64_t m_lastKey = 0;
  struct Number {
    std::uint32_t append, number;
  };
  mutable std::vector<Number> m_numbers; ///< of vertices in an append
  mutable std::uint32_t m_append = 0;
};
