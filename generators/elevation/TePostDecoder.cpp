#include "generators/elevation/TePostDecoder.h"

#include "generators/TeHeightMap.h"

#include <cmath>

TePostDecoder::TePostDecoder(const TeRasterInfo& info, const TeElevationOptions& options,
                             double metresPerStep)
    : m_noData(options.noData), m_signed16(info.signed16), m_float32(info.float32), m_scale(info.scale),
      m_offset(info.offset), m_metres(metresPerStep) {
  if (info.hasNoData)
    m_noData.push_back(info.noData);
}

float TePostDecoder::height(double sample) const {
  if (!std::isfinite(sample) || (m_signed16 && sample == -32768))
    return TeHeightMap::missing();
  for (double noData : m_noData)
    if (sample == noData || (m_float32 && float(sample) == float(noData)))
      return TeHeightMap::missing();
  const double metres = (sample * m_scale + m_offset) * m_metres;
  if (!(std::fabs(metres) <= kMaxHeight) || metres == -32768)
    return TeHeightMap::missing();
  return float(metres);
}
