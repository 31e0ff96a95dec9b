#pragma once

#include "apps/terrane-accuracy/TeFlightStage.h"
#include "apps/terrane-accuracy/TeMeasuredTerrain.h"
#include "apps/terrane-accuracy/TeSpread.h"
#include "nodes/lod/drawing/TeLodArrays.h"
#include "nodes/lod/drawing/TeLodSubmission.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

struct TeSubmissionWay {
  TeLodSubmission way;
  const char* name;
};
constexpr std::array<TeSubmissionWay, 7> kTeSubmissionWays{
    {{TeLodSubmission::Immediate, "immediate"},
     {TeLodSubmission::VertexArrays, "vertex-arrays"},
     {TeLodSubmission::IndexedArrays, "indexed-arrays"},
     {TeLodSubmission::VboStatic, "vbo-static"},
     {TeLodSubmission::VboDynamic, "vbo-dynamic"},
     {TeLodSubmission::VboStream, "vbo-stream"},
     {TeLodSubmission::DisplayLists, "display-lists"}}};

/// A mesh to be sent, and from where it is looked at.
struct TeSubmissionMesh {
  std::string name;
  std::vector<TeLodArrays> parts;
  TePerspectiveView view;

  std::int64_t triangles() const;
  std::int64_t vertices() const;

  /// The terrain's south-west corner of some cells a side, a power of two, with every sample, from above.
  /// Error: one of TeLodField.
  static TeResult<TeSubmissionMesh> grid(const TeMeasuredTerrain& terrain, int cells);
  /// What a LOD method selects for the first frame of the flyover. Error: one of TeLodMethods.
  static TeResult<TeSubmissionMesh> selected(const TeMeasuredTerrain& terrain, const TeFlyover& flight,
                                             const std::string& method, double pixelError);
};

/// What a way took.
struct TeSubmissionFigures {
  TeSpread frameMs;
  double uploadBytes = 0; ///< a frame, after the first
  double drawCalls = 0;
  std::size_t bytes = 0; ///< of the mesh as the way has it
};

/// Sends a mesh in each way in turn, frame by frame, so that all ways meet the same disturbances; after one
/// frame for each that is not counted. By kTeSubmissionWays. Error: one of OpenGL.
TeResult<std::array<TeSubmissionFigures, 7>> teMeasureSubmission(const TeSubmissionMesh& mesh, bool changes,
                                                                 int frames, TeFlightStage& stage,
                                                                 const std::function<void(int)>& progress);
