#pragma once

#include "engine/jobs/TeJob.h"
#include "engine/terrain/TeTerrainPiece.h"
#include "nodes/terrain/TeMeshModelJob.h"
#include "patchdb/TeMeshBuilder.h"
#include "patchdb/TePatchDatabase.h"

/// Makes the node of one piece of the surface: plain arrays, then the model.
class TePieceJob final : public TeJob {
public:
  /// The patches that meet in the piece have heights, and keep them as long as the job lives.
  TePieceJob(const TePatchDatabase& database, const TePatchKey& owner, TeTerrainPiece piece,
             const TeSurfaceColours& colours, std::shared_ptr<TeMeshDrawing> drawing, TeJobKind kind,
             const TeUrgency& urgency);

  const TePatchKey& owner() const { return m_owner; }
  TeTerrainPiece piece() const { return m_piece; }
  TeProgress step(TeAllowance& allowance) override;
  TeJobState state() const override { return m_state; }
  const TeError& error() const override { return m_error; }
  /// Once done; null if the piece has no triangles.
  TeNodePtr<SoTeTerrainMesh> take() { return std::move(m_node); }

private:
  TeProgress makeArrays(TeAllowance& allowance);
  /// At once, in no unit of its own: a seam has few vertices.
  TeProgress makeSeamArrays();
  TeProgress fail(const TeError& error);
  TeProgress makeModel(TeAllowance& allowance);

  const TePatchDatabase& m_database;
  TePatchKey m_owner;
  TeTerrainPiece m_piece;
  TeSurfaceColours m_colours;
  std::shared_ptr<TeMeshDrawing> m_drawing;
  TeJobState m_state = TeJobState::Waiting;
  TeError m_error;
  std::optional<TeMeshBuilder> m_arrays; ///< of an inside
  TePatchMeshPtr m_mesh;
  std::unique_ptr<TeMeshModelJob> m_model;
  TeNodePtr<SoTeTerrainMesh> m_node;
};
