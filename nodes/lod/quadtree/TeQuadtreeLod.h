#pragma once

#include "nodes/lod/TeLodMethod.h"
#include "nodes/lod/quadtree/TeQuadtreeMesh.h"

#include <memory>

/// The adaptive quadtree (docs/adaptive-quadtree.md) as one of the methods; the dial is the document's
/// threshold: an error of z / threshold is accepted at distance z. Parts are squares of a 16th of the side.
/// A budget that is too small for what is wanted is used to 95 % at least, where the mesh has a step there,
/// and the accuracy that was found is kept as long as that is so.
/// Here the data tree is dense; sparse and procedural ones are drawn from TeQuadtreeMesh.
class TeQuadtreeLod final : public TeLodMethod {
public:
  /// Any terrain. Cost: about 0.2 µs a sample, and 16 bytes.
  static TeResult<std::unique_ptr<TeLodMethod>> create(TeLodFieldPtr field);

  std::string name() const override { return "quadtree"; }
  const TeLodDial& dial() const override;
  bool morphs() const override { return true; }
  double bytesPerSample() const override;
  void appendPart(std::size_t part, TeLodMesh& mesh) const override;

  const TeQuadtree& tree() const { return m_tree; }
  const TeQuadtreeMesh& mesh() const { return m_mesh; }

protected:
  void choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance,
              TeLodSelection& selection) override;

  bool coarsens() const override { return false; }

private:
  TeQuadtreeLod(TeLodFieldPtr field, TeQuadtree tree);

  const TeQuadtree m_tree;
  TeQuadtreeMesh m_mesh;
  std::vector<std::size_t> m_chosen; ///< parts of the mesh, by those of the selection
  bool m_acceptedDial = false;
  double m_accepted =
      0; ///< last pixelError, or threshold, that kept the budget; where the next search starts
};
