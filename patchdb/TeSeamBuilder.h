#pragma once

#include "patchdb/TePatchData.h"

/// Builds the part of the surface where patches meet: the seam between two (three columns of samples: the
/// last of one inside, the border, the first of the other) or the corner square between four (3×3 samples).
/// It is built from the south-west one of the patches that meet, so that all of them get the same mesh; its
/// normals are exact, since the heights on all sides are at hand.
/// Error: a patch that takes part is not known or has no heights; the message names it.
TeResult<TePatchMesh> teBuildSeam(const TeLattice& lattice, const TePatchData& patch, TeDirection direction);
