#include "nodes/lod/quadtree/TeQuadtreeLod.h"

#include "generators/base/TeText.h"

TeResult<std::unique_ptr<TeLodMethod>> TeQuadtreeLod::create(TeLodFieldPtr field) {
  TeResult<TeQuadtree> tree = TeQuadtree::create(field->heights());
  if (!tree)
    return tree.error();
  return std::unique_ptr<TeLodMethod>(new TeQuadtreeLod(std::move(field), std::move(*tree)));
}

TeQuadtreeLod::TeQuadtreeLod(TeLodFieldPtr shared, TeQuadtree tree)
    : TeLodMethod(std::move(shared)), m_tree(std::move(tree)), m_mesh(m_tree, field().placement()) {}

const TeLodDial& TeQuadtreeLod::dial() const {
  static const TeLodDial threshold{"threshold", true, 1e-6, 1e9};
  return threshold;
}

double TeQuadtreeLod::bytesPerSample() const {
  const double samples = double(field().cells() + 1) * double(field().cells() + 1);
  return sizeof(float) + double(m_tree.bytes() + m_mesh.bytes()) / samples;
}

void TeQuadtreeLod::choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance&,
                           TeLodSelection& selection) {
  TeQuadtreeMesh::Wish wish;
  wish.pixelError = accuracy.pixelError;
  wish.threshold = accuracy.dial;
  wish.geomorph = accuracy.geomorph;
  const TeQuadtreeMesh::Result& result = m_mesh.update(view, wish);
  m_key += result.changed;
  if (result.triangles > 0)
    selection.parts.push_back({m_key, result.triangles});
  selection.triangles = result.triangles;
  selection.visited = result.visited;
  selection.culled = result.culled;
  selection.splits = result.enabled;
  selection.merges = result.disabled;
  selection.errorBound = result.errorBound;
  selection.dial = accuracy.dial > 0 ? accuracy.dial : view.focal / accuracy.pixelError;
}

void TeQuadtreeLod::appendPart(std::size_t, TeLodMesh& mesh) const { m_mesh.append(mesh); }
