#pragma once

#include "nodes/seamless/TeSeamlessBounds.h"

#include <string>

/// TeSeamlessBounds as a file beside the height pyramid they were measured on.
///
/// Layout, little-endian: "TeSBnds1", then as 32-bit numbers resolution, minimum patch resolution, levels and
/// 0, as 64-bit numbers the bytes that follow the header and the teHashBytes of the 24 bytes from byte 8 on
/// and of what follows the header; then as 32-bit floats the errors of every tree level from 0 (index 0 ..
/// levels - 1 of side 0, of side 1, …), and low and high of the patches of the deepest level, row by row.
class TeSeamlessBoundsFile {
public:
  /// "NAME_bounds_MIN_LEVELS.bin" for a pyramid whose files are NAME_0.raw, NAME_1.raw, ….
  static std::string nameFor(const std::string& pyramid, const TeSeamlessLayout& layout);

  /// Replaces the file in one step. Error: names the file and the reason; an older file stays as it was.
  static TeStatus save(const TeSeamlessBounds& bounds, const std::string& file);
  /// Error, one line that names the file: not readable, no such file of this version, for another layout, cut
  /// off or longer, damaged. Nothing is allocated for a file of another size than the layout asks for.
  static TeResult<std::shared_ptr<const TeSeamlessBounds>> load(const TeSeamlessLayout& layout,
                                                                const std::string& file);
};
