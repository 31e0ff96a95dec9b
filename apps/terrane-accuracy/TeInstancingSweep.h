#pragma once

#include "apps/terrane-accuracy/TeFlightStage.h"
#include "apps/terrane-accuracy/TeInstancingTerrain.h"
#include "apps/terrane-accuracy/TeSpread.h"

#include <array>

/// How a frame's patches are sent.
enum class TeInstancingWay {
  Whole,     ///< a draw call for each list of patches of one combination of resolutions
  Instanced, ///< the document's: one for each list of equal tiles or strips
  Classic    ///< one for each tile and strip
};
constexpr TeInstancingWay kTeInstancingWays[] = {TeInstancingWay::Whole, TeInstancingWay::Instanced,
                                                 TeInstancingWay::Classic};
/// By TeInstancingWay.
template <class Value> using TeByWay = std::array<Value, 3>;

/// What choosing the patches of a flight's frames took: on the CPU alone, and however it is drawn.
struct TeSelectionFigures {
  double triangles = 0; ///< means over the frames
  double patches = 0;
  double visited = 0;
  TeByWay<double> drawCalls{};
  TeSpread ms;                ///< CPU time of selection and lists; the least of three runs a frame
  double nsPerPatch = 0;      ///< of that, a visited patch
  double plainNsPerPatch = 0; ///< TePlainTraversal in the same frames
  double plainVisited = 0;
};

/// What drawing took, as SoTeSeamlessPatches tells.
struct TeDrawingFigures {
  double drawCalls = 0;
  double triangles = 0;
  double uploadBytes = 0; ///< clipmaps' too
  TeSpread selectMs;
  TeSpread frameMs; ///< by the wall clock, until all is drawn
};

/// One terrain, one layout, one flight.
class TeInstancingSweep {
public:
  /// All must outlive it. `bounds` has the layout.
  TeInstancingSweep(const TeInstancingTerrain& terrain, std::shared_ptr<const TeSeamlessBounds> bounds,
                    const TeFlyover& flight, int frames)
      : m_terrain(terrain), m_bounds(std::move(bounds)), m_flight(flight), m_frames(frames) {}

  using Progress = std::function<void(int frame)>;

  /// Windows of clipmaps follow the flight as they do when it is drawn. Error: they cannot be read.
  TeResult<TeSelectionFigures> select(double precision, const Progress& progress) const;
  /// Each frame in all ways in turn. Error: one of OpenGL.
  TeResult<TeByWay<TeDrawingFigures>> draw(double precision, TeFlightStage& stage,
                                           const Progress& progress) const;

private:
  const TeInstancingTerrain& m_terrain;
  std::shared_ptr<const TeSeamlessBounds> m_bounds;
  const TeFlyover& m_flight;
  int m_frames;
};
