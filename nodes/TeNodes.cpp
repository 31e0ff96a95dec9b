#include "nodes/TeNodes.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInteraction.h>
#include <Inventor/nodekits/SoNodeKit.h>

void TeNodes::init() {
  SoDB::init();
  SoNodeKit::init();
  SoInteraction::init();
}
