#include "apps/terrane-accuracy/TeSubmissionSweep.h"

#include "apps/terrane-accuracy/TeSubmissionShape.h"
#include "generators/base/TeText.h"
#include "nodes/lod/TeLodMethods.h"

#include <glm/geometric.hpp>

#include <memory>
#include <utility>

namespace {

TeResult<TeLodFieldPtr> fieldOf(const TeMeasuredTerrain& terrain, int cells) {
  TeResult<TeHeightMap> map = TeHeightMap::create(cells + 1, cells + 1);
  if (!map)
    return map.error();
  for (int y = 0; y <= cells; y++)
    for (int x = 0; x <= cells; x++)
      map->at(x, y) = terrain.heights().at(x, y);
  TeLodField::Placement placement;
  placement.spacing = terrain.spacing();
  placement.heightScale = terrain.heightScale();
  return TeLodField::create(std::make_shared<const TeHeightMap>(std::move(*map)), placement);
}

std::vector<TeLodArrays> partsOf(const TeLodMethod& method) {
  const TeLodArrayMaker maker(method.field(), glm::dvec3(0), nullptr);
  std::vector<TeLodArrays> parts(method.selection().parts.size());
  TeLodMesh mesh;
  for (std::size_t i = 0; i < parts.size(); i++) {
    mesh.clear();
    method.appendPart(i, mesh);
    maker.make(mesh, parts[i]);
  }
  return parts;
}

/// All of a field, from the south and above.
TePerspectiveView overview(const TeLodField& field) {
  const double side = field.cells() * field.spacing();
  const double top = double(field.highest()) * field.heightScale();
  TePerspectiveView view;
  view.eye = {0.5 * side, -0.6 * side, top + 0.9 * side};
  view.forward = glm::normalize(glm::dvec3(0.5 * side, 0.45 * side, top) - view.eye);
  view.nearDistance = 0.01 * side;
  view.farDistance = 10 * side + top;
  return view;
}

} // namespace

std::int64_t TeSubmissionMesh::triangles() const {
  std::int64_t count = 0;
  for (const TeLodArrays& part : parts)
    count += part.triangles();
  return count;
}

std::int64_t TeSubmissionMesh::vertices() const {
  std::int64_t count = 0;
  for (const TeLodArrays& part : parts)
    count += std::int64_t(part.vertices.size());
  return count;
}

TeResult<TeSubmissionMesh> TeSubmissionMesh::grid(const TeMeasuredTerrain& terrain, int cells) {
  const TeResult<TeLodFieldPtr> field = fieldOf(terrain, cells);
  if (!field)
    return field.error();
  TeResult<std::unique_ptr<TeLodMethod>> method = TeLodMethods::create("brute", *field);
  if (!method)
    return method.error();
  (*method)->select(TeLodView(), TeLodAccuracy());
  return TeSubmissionMesh{teFormat("grid of %d² samples", cells + 1), partsOf(**method), overview(**field)};
}

TeResult<TeSubmissionMesh> TeSubmissionMesh::selected(const TeMeasuredTerrain& terrain,
                                                      const TeFlyover& flight, const std::string& name,
                                                      double pixelError) {
  const TeResult<TeLodFieldPtr> field = fieldOf(terrain, terrain.cells());
  if (!field)
    return field.error();
  TeResult<std::unique_ptr<TeLodMethod>> method = TeLodMethods::create(name, *field);
  if (!method)
    return method.error();
  const TePerspectiveView view = flight.view(0);
  TeLodAccuracy accuracy;
  accuracy.pixelError = pixelError;
  (*method)->select(view.lodView(), accuracy);
  return TeSubmissionMesh{teFormat("%s, %g px", name.c_str(), pixelError), partsOf(**method), view};
}

TeResult<std::array<TeSubmissionFigures, 7>> teMeasureSubmission(const TeSubmissionMesh& mesh, bool changes,
                                                                 int frames, TeFlightStage& stage,
                                                                 const std::function<void(int)>& progress) {
  std::array<TeSubmissionFigures, kTeSubmissionWays.size()> figures;
  std::array<std::unique_ptr<TeSubmissionShape>, kTeSubmissionWays.size()> shapes;
  std::array<std::vector<double>, kTeSubmissionWays.size()> times;
  for (std::size_t i = 0; i < shapes.size(); i++)
    shapes[i] = std::make_unique<TeSubmissionShape>(mesh.parts, kTeSubmissionWays[i].way, changes);
  for (int frame = -1; frame < frames; frame++) {
    for (std::size_t i = 0; i < shapes.size(); i++) {
      shapes[i]->change();
      stage.show(shapes[i]->node());
      const TeResult<double> ms = stage.draw(mesh.view);
      if (!ms)
        return ms.error();
      if (!shapes[i]->isUsable())
        return TeError{"this OpenGL has no fixed-function pipeline"};
      if (frame < 0)
        continue;
      times[i].push_back(*ms);
      figures[i].uploadBytes += double(shapes[i]->bytesSent()) / frames;
      figures[i].drawCalls += double(shapes[i]->drawCalls()) / frames;
    }
    progress(frame + 1);
  }
  for (std::size_t i = 0; i < shapes.size(); i++) {
    figures[i].frameMs = TeSpread::of(std::move(times[i]));
    figures[i].bytes = shapes[i]->bytes();
  }
  return figures;
}
