#include "nodes/TeNodes.h"

void TeNodes::init() {}
