#pragma once

#include "patchdb/TeGrowingTree.h"
#include "patchdb/TeRayHit.h"

#include <optional>

/// First hit of a ray, whose direction is not vertical, with the surface of the base patches of a tree.
///
/// The ray passes the tree's boxes front to back, so that unknown land costs nothing however long the ray
/// is, then the cells of a patch from grid line to grid line (Amanatides and Woo 1987). In each cell the
/// ray's height above the surface is linear on both sides of the diagonal; a hit is where its sign changes.
/// The sign is carried from cell to cell and from patch to patch, so that no rounding lets a ray slip through
/// at a line, border or corner. Patches whose heights the ray does not reach are skipped.
std::optional<TeRayHit> teMarchRay(const TeLattice& lattice, const TeGrowingTree& tree, glm::dvec3 origin,
                                   glm::dvec3 direction, double maxDistance);
