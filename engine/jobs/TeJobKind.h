#pragma once

/// What a job is for. Each kind has its share of a tick, so that none starves.
enum class TeJobKind {
  Ground, ///< the patch below an object; before anything else
  Block,  ///< patches of the block that is drawn
  Ahead,  ///< patches that will be needed soon
  Other,  ///< of the program
};
inline constexpr int kTeJobKinds = 4;

/// "ground", "block", "ahead", "other".
const char* teJobKindName(TeJobKind kind);
