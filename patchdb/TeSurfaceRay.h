#pragma once

#include "patchdb/TeGrowingTree.h"
#include "patchdb/TeRayHit.h"

#include <optional>

/// First hit of a ray, whose direction is not vertical, with the surface of the patches of one level, which
/// are in `tree`.
///
/// The ray passes the tree's boxes front to back, so that unknown land costs nothing however long the ray
/// is; then blocks of a patch's cells (TeHeightBlocks), and the cells of those blocks whose heights it
/// reaches, from grid line to grid line (Amanatides and Woo 1987). In each cell the ray's height above the
/// surface is linear on both sides of the diagonal; a hit is where its sign changes. The sign is carried from
/// cell to cell, block to block and patch to patch, so that no rounding lets a ray slip through at a line,
/// border or corner.
std::optional<TeRayHit> teMarchRay(const TeLattice& lattice, const TeGrowingTree& tree, int level,
                                   glm::dvec3 origin, glm::dvec3 direction, double maxDistance);
