#include "nodes/terrain/TeStaticTerrain.h"

#include "nodes/TeNodes.h"

void TeStaticTerrain::initClass() { TeNodes::init(); }
