#include "nodes/seamless/TeSeamlessPatches.h"

#include "nodes/TeNodes.h"

void TeSeamlessPatches::initClass() { TeNodes::init(); }
