#pragma once

/// How far a job has come.
enum class TeJobState {
  Waiting,    ///< not begun
  SourceMaps, ///< finds or makes its source maps
  Blend,      ///< makes heights from them
  Arrays,     ///< makes plain arrays of vertices
  Model,      ///< makes nodes
  Inserted,   ///< done: in the scene, or ready for it
  Cancelled,
  Failed,
};
inline constexpr int kTeJobStates = 8;

/// "waiting", "source maps", "blend", "arrays", "model", "inserted", "cancelled", "failed".
const char* teJobStateName(TeJobState state);
