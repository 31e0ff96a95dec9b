#pragma once

#include "nodes/lod/TeLodBox.h"
#include "nodes/lod/TeLodMethod.h"
#include "nodes/lod/geomipmap/TeGeoMipErrors.h"
#include "nodes/lod/geomipmap/TeGeoMipMesh.h"
#include "nodes/lod/geomipmap/TeGeoMipPatterns.h"

#include <memory>
#include <vector>

/// Geometrical mip mapping (de Boer 2000; docs/geomipmapping.md): patches of equal size, each drawn at a
/// level of its own, stitched to coarser neighbours by leaving out vertices of the border.
///
/// A patch has the coarsest level whose error, at the distance of its box, is within the wanted one.
/// Neighbours may differ by any number of levels; where the strip between them would not be within it, the
/// coarser one becomes finer. Boxes of patches form a quadtree that culls.
///
/// With `geomorph` vertices that the next coarser level lacks stand between its surface and their own
/// heights, by a weight of the patch; on a border by that of the coarser patch, or the lesser of two equal
/// ones.
///
/// Dial: de Boer's threshold in pixels, by the midpoint errors and the distance of the patch's middle; the
/// bound that is stated is exact all the same.
///
/// Cost: in proportion to the nodes of the quadtree in view.
class TeGeoMipMapping final : public TeLodMethod {
public:
  struct Settings {
    /// A side, a power of two from 2 to 128; less where the terrain is smaller. 0: so many that there are 128
    /// patches a side, but 8 to 32: few triangles for the number of patches (docs/geomipmapping.md).
    int patchCells = 0;
  };

  /// Error: settings out of range, more than 4096 patches a side.
  static TeResult<std::unique_ptr<TeLodMethod>> create(TeLodFieldPtr field, const Settings& settings);
  static TeResult<std::unique_ptr<TeLodMethod>> create(TeLodFieldPtr field) {
    return create(std::move(field), Settings());
  }

  std::string name() const override { return "geomipmap"; }
  const TeLodDial& dial() const override;
  bool morphs() const override { return true; }
  double bytesPerSample() const override;
  void appendPart(std::size_t part, TeLodMesh& mesh) const override;

  const TeGeoMipErrors& errors() const { return m_errors; }
  const TeGeoMipPatterns& patterns() const { return m_patterns; }

protected:
  void choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance,
              TeLodSelection& selection) override;
  bool coarsens() const override { return m_canCoarsen; }

private:
  TeGeoMipMapping(TeLodFieldPtr field, int patchCells);

  struct Drawn {
    int x = 0;
    int y = 0;
    double distance = 0;
    double largest = 0; ///< deviation that is within the wanted error
    int weight = TeGeoMipPart::kWhole;
  };
  struct Wish;

  void visit(const Wish& wish, int height, int x, int y, unsigned planes, TeLodSelection& selection);
  void draw(const Wish& wish, int x, int y, const TeLodBox& box);
  int morphLevel(const Wish& wish, const TeGeoMipErrors::Patch& errors, double largest) const;
  void refineNeighbours();
  void weigh(const Wish& wish);
  void raiseWeight(Drawn& drawn, double share);
  void raiseWeights();
  TeGeoMipPart partOf(const Drawn& drawn, bool geomorph) const;
  void report(const Wish& wish, TeLodSelection& selection);
  TeLodBox box(int height, int x, int y) const;

  /// Of patches, with a rim of patches that are not there.
  std::size_t cell(int x, int y) const {
    return std::size_t(y + 1) * std::size_t(m_patches + 2) + std::size_t(x + 1);
  }
  std::size_t beside(std::size_t cell, int side) const {
    const std::size_t width = std::size_t(m_patches) + 2;
    return side == 0 ? cell - width : side == 1 ? cell + 1 : side == 2 ? cell + width : cell - 1;
  }

  TeGeoMipPatterns m_patterns;
  TeGeoMipErrors m_errors;
  TeGeoMipMesh m_mesh;
  int m_patches;
  /// [height][y·side + x]: ranges of 2^height patches a side, from height 1 on.
  std::vector<std::vector<TeGeoMipErrors::Range>> m_ranges;

  std::vector<std::uint8_t> m_levels;  ///< by cell(); kNotDrawn
  std::vector<std::uint32_t> m_places; ///< by cell(): in m_drawn, where it is drawn
  std::vector<Drawn> m_drawn;
  std::vector<std::uint32_t> m_pending; ///< in m_drawn
  bool m_canCoarsen = true;
};
