#include "nodes/lod/quadtree/TeQuadtreeLod.h"

#include "nodes/lod/quadtree/TeQuadtreeBudget.h"

#include <algorithm>
#include <cmath>

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
  const bool usesDial = accuracy.dial > 0;
  TeQuadtreeMesh::Wish wish;
  wish.geomorph = accuracy.geomorph;
  const double exactStep = 1.0 / 64; // pixels, where an exact mesh has to be made coarser
  const double first = std::max(accuracy.pixelError, exactStep);
  const auto triangles = [&](double coarsening) {
    wish.pixelError = coarsening > 1 ? first * coarsening : accuracy.pixelError;
    wish.threshold = accuracy.dial / coarsening;
    m_key += m_mesh.update(view, wish).changed;
    return m_mesh.result().triangles;
  };
  const double last = usesDial ? accuracy.dial / m_accepted : m_accepted / first;
  const bool wasCoarser = m_accepted > 0 && m_acceptedDial == usesDial && last > 1 && std::isfinite(last);
  const double coarsening = TeQuadtreeBudget::search(accuracy.maxTriangles, wasCoarser ? last : 1, triangles);
  m_accepted = usesDial ? accuracy.dial / coarsening : first * coarsening;
  m_acceptedDial = usesDial;

  const TeQuadtreeMesh::Result& result = m_mesh.result();
  if (result.triangles > 0)
    selection.parts.push_back({m_key, result.triangles});
  selection.triangles = result.triangles;
  selection.visited = result.visited;
  selection.culled = result.culled;
  selection.splits = result.enabled;
  selection.merges = result.disabled;
  selection.errorBound = result.errorBound;
  selection.dial = usesDial ? wish.threshold : view.focal / wish.pixelError;
  selection.coarsening = coarsening;
}

void TeQuadtreeLod::appendPart(std::size_t, TeLodMesh& mesh) const { m_mesh.append(mesh); }
