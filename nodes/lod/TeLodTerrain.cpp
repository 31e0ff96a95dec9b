#include "nodes/lod/TeLodTerrain.h"

#include "nodes/TeNodes.h"

void TeLodTerrain::initClass() { TeNodes::init(); }
