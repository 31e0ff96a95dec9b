#pragma once

#include "apps/terrane-accuracy/TeMeasuredTerrain.h"
#include "nodes/seamless/TeSeamlessMesh.h"

#include <cstdint>
#include <vector>

/// How many edges of a mesh are no edges of exactly two triangles with the same heights at both ends, in view
/// and not on the terrain's rim. Cost: sorts the edges.
std::int64_t teCountCracks(const std::vector<TeSeamlessMesh::Triangle>& triangles,
                           const TeMeasuredTerrain& terrain, const TeLodView& view);
