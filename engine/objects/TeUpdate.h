#pragma once

class TePatchDatabase;

/// What an object may know when it is updated.
struct TeUpdate {
  double dt = 0;                  ///< seconds, more than 0, at most TeObjects::kLongestStep
  double time = 0;                ///< simulated seconds since the start, at the end of this step
  const TePatchDatabase& terrain; ///< the known surface: heights, normals, rays
};
