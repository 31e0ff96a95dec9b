#pragma once

#include "nodes/seamless/TeSeamlessParts.h"
#include "nodes/seamless/TeSeamlessSelection.h"

#include <array>
#include <cstdint>
#include <vector>

/// One patch or one part of it, as the vertex shader reads it: four integers.
struct TeSeamlessInstance {
  std::int32_t column = 0; ///< south-west corner of the patch, in samples
  std::int32_t row = 0;
  std::int32_t cellsLog = 0; ///< the patch has 2^cellsLog samples' distances a side
  std::uint32_t weights = 0; ///< morph weights·255, 8 bits a side (TeSide, the lowest first)

  int weight(int side) const { return int(weights >> (8 * side) & 255); }
};

/// A run of instances that are drawn with the same triangles: one draw call.
struct TeSeamlessDraw {
  enum Kind : std::uint8_t { Patch, Tile, Strip };
  TePart part;
  Kind kind = Patch;
  std::uint8_t orientation = 0; ///< TeSide of the tile, or before the strip
  /// Resolution indices by TeSide: all of a patch, that of a tile's side, those of a strip's two.
  std::array<std::uint8_t, 4> indices{};
  std::int32_t firstInstance = 0;
  std::int32_t instanceCount = 0;
};

/// A selection sorted into lists: what is sent to OpenGL.
///
/// By parts, as in the document: a list for each part, orientation and resolution or pair of them; eight
/// instances a patch, up to 4·levels·(levels + 1) draw calls. (The document's lists have one clipmap level
/// too; here each instance carries its own.) By whole patches: a list for each combination of resolutions
/// that occurs, which are few; one instance a patch.
class TeSeamlessLists {
public:
  /// By whole patches if `parts` has them. Cost: two passes over the patches. Memory is used again.
  void build(const TeSeamlessSelection& selection, const TeSeamlessLayout& layout,
             const TeSeamlessParts& parts);

  const std::vector<TeSeamlessInstance>& instances() const { return m_instances; }
  const std::vector<TeSeamlessDraw>& draws() const { return m_draws; }

private:
  /// Adds a draw for a list that is not empty, and makes its count the place of its next instance.
  void addDraw(std::size_t list, TeSeamlessDraw draw);
  void addPartDraws(const TeSeamlessParts& parts);
  void addPatchDraws(const TeSeamlessParts& parts);

  std::vector<TeSeamlessInstance> m_instances;
  std::vector<TeSeamlessDraw> m_draws;
  std::vector<std::int32_t> m_counts; ///< by list
  std::int32_t m_next = 0;            ///< instance
};
