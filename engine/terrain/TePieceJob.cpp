#include "engine/terrain/TePieceJob.h"

TePieceJob::TePieceJob(const TePatchDatabase& database, const TePatchKey& owner, TeTerrainPiece piece,
                       const TeSurfaceColours& colours, std::shared_ptr<TeMeshDrawing> drawing,
                       TeJobKind kind, const TeUrgency& urgency)
    : TeJob(kind, urgency), m_database(database), m_owner(owner), m_piece(piece), m_colours(colours),
      m_drawing(std::move(drawing)) {}

TeProgress TePieceJob::step(TeAllowance& allowance) {
  if (!m_mesh) {
    m_state = TeJobState::Arrays;
    const TeProgress arrays = m_piece == TeTerrainPiece::Inside ? makeArrays(allowance) : makeSeamArrays();
    if (arrays != TeProgress::Done)
      return arrays;
    m_state = TeJobState::Model;
    if (allowance.exhausted())
      return TeProgress::Working;
  }
  const TeProgress model = makeModel(allowance);
  if (model == TeProgress::Done)
    m_state = TeJobState::Inserted;
  return model;
}

TeProgress TePieceJob::fail(const TeError& error) {
  m_error = error;
  m_state = TeJobState::Failed;
  return TeProgress::Failed;
}

TeProgress TePieceJob::makeArrays(TeAllowance& allowance) {
  if (!m_arrays) {
    TeResult<TeMeshBuilder> builder = m_database.meshBuilder(*m_database.find(m_owner));
    if (!builder)
      return fail(builder.error());
    m_arrays.emplace(std::move(*builder));
  }
  if (!m_arrays->step(allowance))
    return TeProgress::Working;
  m_mesh = std::make_shared<const TePatchMesh>(m_arrays->take());
  m_arrays.reset();
  return TeProgress::Done;
}

TeProgress TePieceJob::makeSeamArrays() {
  TeResult<TePatchMesh> mesh = m_database.seamMesh(*m_database.find(m_owner), tePieceDirection(m_piece));
  if (!mesh)
    return fail(mesh.error());
  m_mesh = std::make_shared<const TePatchMesh>(std::move(*mesh));
  return TeProgress::Done;
}

TeProgress TePieceJob::makeModel(TeAllowance& allowance) {
  if (m_mesh->strips.empty())
    return TeProgress::Done;
  if (!m_model)
    m_model = std::make_unique<TeMeshModelJob>(m_mesh, m_colours, m_drawing);
  if (!m_model->step(allowance))
    return TeProgress::Working;
  m_node = m_model->take();
  m_model.reset();
  return TeProgress::Done;
}
