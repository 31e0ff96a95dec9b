#pragma once

#include <glm/vec3.hpp>

/// Exact normals of a height grid: central differences of the four nearest samples,
///
///     n = normalize(h(x-1, y) - h(x+1, y), h(x, y-1) - h(x, y+1), 2·spacing),
///
/// in double, rounded to float once. A pure function of five heights and the spacing: whoever computes the
/// normal of a sample gets the same bits. Flat ground gives exactly (0, 0, 1).
///
/// Where one neighbour is missing the difference to the sample itself counts twice; where both are, the
/// slope is 0; at a missing sample the normal is (0, 0, 1). Always finite and of unit length (to float
/// rounding) for finite heights and spacings from 1e-100 to 1e100 metres.
glm::vec3 teSampleNormal(float here, float west, float east, float south, float north, double spacing);

/// Normals of a block of samples: normal (x, y) = normals[y * columns + x] belongs to heights[y * stride +
/// x]. The ring of samples around the block must be readable: heights points to the block's first sample.
/// `missing` tells whether there may be missing samples in the block or its ring.
/// Cost: see docs/seams.md.
void teGridNormals(const float* heights, int stride, int columns, int rows, double spacing, bool missing,
                   glm::vec3* normals);
