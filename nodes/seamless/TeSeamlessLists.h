#pragma once

#include "nodes/seamless/TeSeamlessParts.h"
#include "nodes/seamless/TeSeamlessSelection.h"

#include <cstdint>
#include <vector>

/// One part of one patch, as the vertex shader reads it.
struct TeSeamlessInstance {
  std::int32_t column = 0; ///< south-west corner of the patch, in samples
  std::int32_t row = 0;
  std::uint8_t cellsLog = 0;      ///< the patch has 2^cellsLog samples' distances a side
  std::uint8_t heightLevel = 0;   ///< level of the height pyramid that has all of the part's vertices
  std::uint8_t weightFirst = 255; ///< morph weights·255 of chains First and Second (TePartVertex)
  std::uint8_t weightSecond = 255;
};

/// A run of instances that are drawn with the same triangles: one draw call.
struct TeSeamlessDraw {
  TePart part;
  bool strip = false;
  std::uint8_t orientation = 0; ///< TeSide of the tile, or before the strip
  std::uint8_t first = 0;       ///< resolution index of the side, or of the side before the strip
  std::uint8_t second = 0;      ///< strip: resolution index of the side after it
  std::int32_t firstInstance = 0;
  std::int32_t instanceCount = 0;
};

/// A selection sorted into lists by (part, orientation, resolutions): what is sent to OpenGL. A list of the
/// document has one clipmap level too; here each instance carries its own, so there are fewer calls.
class TeSeamlessLists {
public:
  /// Cost: two passes over the patches. Memory is used again.
  void build(const TeSeamlessSelection& selection, const TeSeamlessLayout& layout,
             const TeSeamlessParts& parts);

  const std::vector<TeSeamlessInstance>& instances() const { return m_instances; }
  const std::vector<TeSeamlessDraw>& draws() const { return m_draws; }

private:
  std::vector<TeSeamlessInstance> m_instances;
  std::vector<TeSeamlessDraw> m_draws;
  std::vector<std::int32_t> m_counts;
};
