#pragma once

#include "generators/TeSourceChooser.h"
#include "patchdb/TeBlendWeights.h"

/// What the world is made of.
struct TeWorld {
  TeLattice lattice;
  std::uint64_t seed = 0;
  std::shared_ptr<const TeSourceChooser> sources;
  TeBlendProfile blending = TeBlendProfile::Smooth;
};
