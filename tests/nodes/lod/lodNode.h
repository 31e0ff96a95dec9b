#pragma once

#include "nodes/lod/SoTeLodTerrain.h"
#include "nodes/lod/TeLodMethods.h"
#include "nodes/seamless/hillsNode.h"

/// Hills on a square of `side` metres around (0, 0), drawn by a LOD method.
inline TeNodePtr<SoTeLodTerrain> lodNode(const std::string& method, int resolution = 128, float side = 1000) {
  TeNodePtr<SoTeLodTerrain> node(new SoTeLodTerrain);
  node->method = method.c_str();
  node->size.setValue(side, side, 0);
  node->pixelError = 2;
  node->setHeights(std::make_shared<const TeHeightMap>(hillsMap(resolution)));
  return node;
}

/// The midpoint form of RTIN is here to show what is no bound.
inline bool lodTellsBound(const std::string& method) { return method != "rtin-midpoint"; }
