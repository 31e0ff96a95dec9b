#include "generators/elevation/TeGdal.h"

#include "generators/base/TeModule.h"

TeResult<const TeGdal*> TeGdal::module() {
  const TeResult<void*> symbol = teModuleSymbol("TerraneGdal", "teGdalModule");
  if (!symbol)
    return TeError{"this format needs GDAL, and Terrane was built or installed without it (" +
                   symbol.error().message + ")"};
  const auto get = reinterpret_cast<const TeGdal* (*)()>(*symbol);
  return get();
}
