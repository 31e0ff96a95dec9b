#include "nodes/lod/quadtree/TeQuadtreeLod.h"

#include "nodes/lod/TeMeshBudget.h"

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
    return m_mesh.update(view, wish).triangles;
  };
  const double last = usesDial ? accuracy.dial / m_accepted : m_accepted / first;
  const bool wasCoarser = m_accepted > 0 && m_acceptedDial == usesDial && last > 1 && std::isfinite(last);
  const double coarsening = TeMeshBudget::search(accuracy.maxTriangles, wasCoarser ? last : 1, triangles);
  m_accepted = usesDial ? accuracy.dial / coarsening : first * coarsening;
  m_acceptedDial = usesDial;

  const TeQuadtreeMesh::Result& result = m_mesh.result();
  m_chosen.clear();
  for (std::size_t part = 0; part < m_mesh.parts().size(); part++) {
    const TeQuadtreeMesh::Part& drawn = m_mesh.parts()[part];
    if (drawn.triangles == 0)
      continue;
    selection.parts.push_back({drawn.key, drawn.triangles});
    m_chosen.push_back(part);
  }
  selection.triangles = result.triangles;
  selection.visited = result.visited;
  selection.culled = result.culled;
  selection.splits = result.enabled;
  selection.merges = result.disabled;
  selection.errorBound = result.errorBound;
  selection.dial = usesDial ? wish.threshold : view.focal / wish.pixelError;
  selection.coarsening = coarsening;
}

void TeQuadtreeLod::appendPart(std::size_t part, TeLodMesh& mesh) const {
  m_mesh.append(m_mesh.parts()[m_chosen[part]], mesh);
}
