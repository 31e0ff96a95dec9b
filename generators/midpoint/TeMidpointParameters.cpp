#include "generators/midpoint/TeMidpointParameters.h"

TeParameters TeMidpointParameters::table() {
  return {
      {"variant", &variant, 0, 0, {"uniform", "gaussian"}, "distribution of the displacements"},
      {"displacement",
       &displacement,
       0,
       1e6,
       {},
       "first displacement (largest, or standard deviation), metres"},
      {"fall", &fall, 0, 1, {}, "factor of the displacement from level to level"},
      {"seed", &seed, 0, 0, {}, "the generator's own seed"},
  };
}
