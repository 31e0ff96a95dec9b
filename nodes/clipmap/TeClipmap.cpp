#include "nodes/clipmap/TeClipmap.h"

#include "nodes/TeNodes.h"

void TeClipmap::initClass() { TeNodes::init(); }
