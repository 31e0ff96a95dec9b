#pragma once

#include "nodes/lod/TeLodMethod.h"
#include "nodes/lod/rtin/TeRtinErrors.h"
#include "nodes/lod/rtin/TeRtinRanges.h"
#include "nodes/lod/rtin/TeRtinTest.h"
#include "nodes/lod/rtin/TeRtinTriangle.h"

#include <cstdint>
#include <vector>

/// Right-triangulated irregular network (docs/rtin.md): right triangles, halved at the middle of their
/// hypotenuse where their error is too large for the view. The dial is the largest error in metres over the
/// whole terrain, whatever the view.
///
/// With exact errors the bound holds. With midpoint errors, the usual ones, there is none: errorBound is
/// infinite, unless all samples are drawn.
///
/// Chosen anew each time, from the two halves of the terrain down; no node is stored. A budget that is too
/// small for what is wanted is used to 95 % at least, where a mesh has so many; the search for that begins
/// with what the last selection came to, and ends there if it still does. Memory: 4 bytes a sample for
/// errors, 0.67 for ranges of heights, 1/8 for marks. Cost: in proportion to the triangles.
class TeRtinLod final : public TeLodMethod {
public:
  TeRtinLod(TeLodFieldPtr field, TeRtinError error);

  std::string name() const override;
  const TeLodDial& dial() const override;
  double bytesPerSample() const override;
  void appendPart(std::size_t part, TeLodMesh& mesh) const override;

  const std::vector<float>& errors() const { return m_errors; }

protected:
  void choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance,
              TeLodSelection& selection) override;
  bool coarsens() const override { return false; }

private:
  static constexpr int kPartsLog = 3; ///< parts are halves of squares of the terrain's side / 2^kPartsLog

  using Corner = TeRtinTriangle::Corner;
  /// Of a selection: where its triangles are among the corners.
  struct Part {
    std::size_t first = 0;
    std::size_t count = 0;
    Corner low; ///< of the square that holds it
  };

  std::size_t indexOf(const Corner& corner) const {
    return std::size_t(corner.row) * std::size_t(m_cells + 1) + std::size_t(corner.column);
  }
  bool isMarked(std::size_t index) const { return (m_marks[index / 64] >> (index % 64) & 1) != 0; }
  /// Makes a mesh; returns its triangles, or at least as many as have been counted when it was given up.
  std::int64_t make(TeRtinTest& test, TeLodSelection& selection);
  void clearMarks();
  void mark(const Corner& vertex);
  void markWhatIsNeeded(TeRtinTest& test, const TeRtinTriangle& triangle, std::uint32_t planes,
                        double distance, TeLodSelection& selection);
  void emitParts(const TeRtinTest& test, const TeRtinTriangle& triangle, std::uint32_t planes,
                 std::uint64_t number, TeLodSelection& selection);
  void emit(const TeRtinTest& test, const TeRtinTriangle& triangle, std::uint32_t planes);

  int m_cells;
  TeRtinError m_error;
  std::vector<float> m_errors;
  TeRtinRanges m_ranges;

  std::vector<std::uint64_t> m_marks; ///< a bit a sample: it is a vertex
  std::vector<std::uint32_t> m_marked;
  std::int64_t m_terminals = 0; ///< triangles found fine
  std::int64_t m_most = 0;      ///< of them; more is given up
  double m_accepted = 0;        ///< last pixelError, or dial, that kept the budget; 0: none
  bool m_acceptedDial = false;
  std::vector<std::uint32_t> m_corners; ///< samples, three a triangle
  std::vector<Part> m_parts;

  /// What tells parts apart: the tree below each, two bits a triangle.
  struct Code {
    std::uint64_t hash = 0;
    std::uint64_t bits = 1;
    void add(std::uint64_t two);
    std::uint64_t finish();
  };
  Code m_code;

  mutable std::vector<std::uint32_t> m_numbers; ///< of samples in a part's square; one more, 0: none
};
