#include "nodes/terrain/SoTeTerrainDetail.h"

SO_DETAIL_SOURCE(SoTeTerrainDetail)

void SoTeTerrainDetail::initClass() {
  if (classTypeId == SoType::badType())
    SO_DETAIL_INIT_CLASS(SoTeTerrainDetail, SoDetail);
}
