#include "generators/circles/TeCirclesParameters.h"

TeParameters TeCirclesParameters::table() {
  return {
      {"circles", &circles, 1, 1000000, {}, "number of circles"},
      {"smallest", &smallest, 1e-6, 1e6, {}, "least radius, metres"},
      {"largest", &largest, 1e-6, 1e6, {}, "greatest radius, metres"},
      {"height", &height, 0, 1e6, {}, "greatest height of a hill of the greatest radius, metres"},
      {"seed", &seed, 0, 0, {}, "the generator's own seed"},
  };
}
