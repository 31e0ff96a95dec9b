#pragma once

#include "nodes/seamless/TeSeamlessBounds.h"

#include <string>

/// TeSeamlessBounds as a file beside the height pyramid they were measured on.
///
/// Layout, little-endian: "TeSBnds1"; as 32-bit numbers resolution, minimum patch resolution and levels; as
/// 32-bit floats the errors of every tree level from 0 (index 0 .. levels - 1 of side 0, of side 1, …), then
/// low and high of the patches of the deepest level, row by row; as a 64-bit number the teHashBytes of all
/// before, in pieces of 64 KiB with the hash of the one before for a seed.
class TeSeamlessBoundsFile {
public:
  /// "NAME_bounds_MIN_LEVELS.bin" for a pyramid whose files are NAME_0.raw, NAME_1.raw, ….
  static std::string nameFor(const std::string& pyramid, const TeSeamlessLayout& layout);

  /// Writes "FILE.part", which takes the file's place when it is whole. Error: names the file and the reason;
  /// an older file stays as it was.
  static TeStatus save(const TeSeamlessBounds& bounds, const std::string& file);
  /// Error, one line that names the file: not readable, no such file of this version, for another layout, cut
  /// off or longer, damaged, not enough memory. Nothing is allocated for a file of another size than the
  /// layout asks for.
  static TeResult<std::shared_ptr<const TeSeamlessBounds>> load(const TeSeamlessLayout& layout,
                                                                const std::string& file);
};
