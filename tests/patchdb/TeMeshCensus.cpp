#include "patchdb/TeMeshCensus.h"

#include <cstring>

double TeMeshCensus::Triangle::areaInPlan() const {
  const glm::dvec3 a = corners[1] - corners[0];
  const glm::dvec3 b = corners[2] - corners[0];
  return 0.5 * (a.x * b.y - a.y * b.x);
}

bool TeMeshCensus::add(const TePatchMesh& mesh) {
  bool agrees = true;
  const auto world = [&](std::int32_t v) { return mesh.origin + glm::dvec3(mesh.positions[std::size_t(v)]); };
  const auto addTriangle = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    const std::array<std::int32_t, 3> v = {a, b, c};
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corners[i] = world(v[i]);
      const glm::dvec3 next = world(v[(i + 1) % 3]);
      const Point from = {triangle.corners[i].x, triangle.corners[i].y};
      const Point to = {next.x, next.y};
      if (from < to)
        ++m_edges[{from, to}].forth;
      else
        ++m_edges[{to, from}].back;
      const Sample sample = {mesh.positions[std::size_t(v[i])].z, mesh.normals[std::size_t(v[i])]};
      const auto [known, isNew] = m_samples.insert({from, sample});
      agrees = agrees && (isNew || (std::memcmp(&known->second.height, &sample.height, sizeof(float)) == 0 &&
                                    std::memcmp(&known->second.normal, &sample.normal, 12) == 0));
    }
    m_triangles.push_back(triangle);
  };
  std::size_t first = 0;
  for (std::size_t i = 0; i < mesh.strips.size(); ++i) {
    if (mesh.strips[i] < 0) {
      first = i + 1;
      continue;
    }
    if (i < first + 2)
      continue;
    const std::int32_t a = mesh.strips[i - 2], b = mesh.strips[i - 1], c = mesh.strips[i];
    (i - first) % 2 == 0 ? addTriangle(a, b, c) : addTriangle(b, a, c);
  }
  return agrees;
}

long TeMeshCensus::edgesWithTwoTriangles() const {
  long count = 0;
  for (const auto& [points, edge] : m_edges)
    count += edge.forth == 1 && edge.back == 1 ? 1 : 0;
  return count;
}

std::vector<std::array<glm::dvec3, 2>> TeMeshCensus::rim() const {
  std::vector<std::array<glm::dvec3, 2>> rim;
  for (const auto& [points, edge] : m_edges)
    if (edge.forth + edge.back == 1)
      rim.push_back({glm::dvec3(points[0][0], points[0][1], 0), glm::dvec3(points[1][0], points[1][1], 0)});
  return rim;
}

long TeMeshCensus::brokenEdges() const {
  long count = 0;
  for (const auto& [points, edge] : m_edges)
    count += edge.forth > 1 || edge.back > 1 ? 1 : 0;
  return count;
}

std::vector<TePatchMesh> teBlockMeshes(const TePatchDatabase& database, TePatchKey southWest, int columns,
                                       int rows) {
  std::vector<TePatchMesh> meshes;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const TePatchData& patch = *database.find({southWest.x + x, southWest.y + y, southWest.level});
      meshes.push_back(*database.patchMesh(patch));
      if (x + 1 < columns)
        meshes.push_back(*database.seamMesh(patch, TeDirection::East));
      if (y + 1 < rows)
        meshes.push_back(*database.seamMesh(patch, TeDirection::North));
      if (x + 1 < columns && y + 1 < rows)
        meshes.push_back(*database.seamMesh(patch, TeDirection::NorthEast));
    }
  return meshes;
}
