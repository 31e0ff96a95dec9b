#pragma once

#include "nodes/lod/TeLodMethod.h"

#include <vector>

/// Every sample in view: patches of kPatchCells² cells, left out where they are not in view. The surface that
/// all other methods are measured against.
///
/// Cost: in proportion to the patches.
class TeBruteForce final : public TeLodMethod {
public:
  static constexpr int kPatchCells = 32; ///< a side; less where the terrain is smaller

  explicit TeBruteForce(TeLodFieldPtr field);

  std::string name() const override { return "brute"; }
  const TeLodDial& dial() const override;
  double bytesPerSample() const override;
  void appendPart(std::size_t part, TeLodMesh& mesh) const override;

protected:
  void choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance,
              TeLodSelection& selection) override;
  bool coarsens() const override { return false; }

private:
  struct Range {
    float low = 0;
    float high = 0;
  };

  int m_patchCells;
  int m_patches;               ///< a side
  std::vector<Range> m_ranges; ///< patch (x, y) at y·m_patches + x
};
