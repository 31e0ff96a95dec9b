#include "nodes/TeNodes.h"

#include "nodes/clipmap/SoTeClipmap.h"
#include "nodes/lod/SoTeLodTerrain.h"
#include "nodes/seamless/SoTeSeamlessPatches.h"
#include "nodes/terrain/SoTeStaticTerrain.h"
#include "nodes/terrain/SoTeTerrainDetail.h"
#include "nodes/terrain/SoTeTerrainMesh.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInteraction.h>
#include <Inventor/nodekits/SoNodeKit.h>

void TeNodes::init() {
  SoDB::init();
  SoNodeKit::init();
  SoInteraction::init();
  SoTeTerrainDetail::initClass();
  SoTeClipmap::initClass();
  SoTeLodTerrain::initClass();
  SoTeSeamlessPatches::initClass();
  SoTeStaticTerrain::initClass();
  SoTeTerrainMesh::initClass();
}
