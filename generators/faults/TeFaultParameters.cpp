#include "generators/faults/TeFaultParameters.h"

TeParameters TeFaultParameters::table() {
  return {
      {"faults", &faults, 1, 100000, {}, "number of faults"},
      {"first", &first, 1e-6, 1e6, {}, "metres by which the first fault raises one side"},
      {"last", &last, 1e-6, 1e6, {}, "metres by which the last fault raises one side"},
      {"profile", &profile, 0, 0, {"step", "smooth"}, "cliff or ramp along a fault's line"},
      {"width", &width, 1e-6, 1e6, {}, "metres across the first fault's ramp (smooth profile)"},
      {"centred", &centred, 0, 0, {}, "mean height 0 instead of half the sum of all faults"},
      {"seed", &seed, 0, 0, {}, "the generator's own seed"},
  };
}
