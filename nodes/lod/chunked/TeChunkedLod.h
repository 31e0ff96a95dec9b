#pragma once

#include "nodes/lod/TeLodMethod.h"
#include "nodes/lod/chunked/TeChunkMesh.h"
#include "nodes/lod/chunked/TeChunkTree.h"

#include <memory>
#include <vector>

/// Chunked LOD (Ulrich 2002; docs/chunked-lod.md): a quadtree of chunks, drawn from the top down until each
/// one's error, at the distance of its box, is within the wanted one; skirts cover what does not fit.
///
/// With `geomorph` vertices stand on the parent's surface when a chunk appears, and come to their own heights
/// as the viewer comes nearer: as near as the wanted error asks.
///
/// Dial: Ulrich's tau, the largest screen error in pixels by the levels' errors, which halve from level to
/// level; pixelError goes by each chunk's own, which is less.
///
/// Cost: in proportion to the chunks in view.
class TeChunkedLod final : public TeLodMethod {
public:
  struct Settings {
    int leafCells = 16; ///< a side, a power of two from 2; less where the terrain is smaller
    /// Error of the chunks above the leaves, in the unit of the samples. Negative: what a quarter of the
    /// samples exceed (docs/chunked-lod.md).
    double firstError = -1;
  };

  /// Error: settings out of range.
  static TeResult<std::unique_ptr<TeLodMethod>> create(TeLodFieldPtr field, const Settings& settings);
  static TeResult<std::unique_ptr<TeLodMethod>> create(TeLodFieldPtr field) {
    return create(std::move(field), Settings());
  }

  std::string name() const override { return "chunked"; }
  const TeLodDial& dial() const override;
  bool morphs() const override { return true; }
  double bytesPerSample() const override;
  void appendPart(std::size_t part, TeLodMesh& mesh) const override;

  const TeChunkTree& tree() const { return m_tree; }

protected:
  void choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance,
              TeLodSelection& selection) override;
  bool coarsens() const override { return m_canCoarsen; }

private:
  TeChunkedLod(TeLodFieldPtr field, int leafCells, float firstError);

  enum class State : std::uint8_t { Unseen, Drawn, Divided };
  struct Drawn {
    TeChunkPart part;
    double distance = 0;
  };
  struct Wish;
  void visit(const Wish& wish, int level, int x, int y, unsigned planes, double largestOfParent,
             TeLodSelection& selection);
  int weight(int level, int x, int y, double largestOfParent) const;
  /// What lies beyond a side of a chunk that is drawn.
  int beyond(const TeChunkPart& part, int side) const;

  TeChunkTree m_tree;
  std::vector<State> m_states; ///< by number of the chunk
  std::vector<std::size_t> m_touched;
  std::vector<Drawn> m_drawn;
  mutable TeChunkMesh m_mesh;
  bool m_canCoarsen = true;
};
