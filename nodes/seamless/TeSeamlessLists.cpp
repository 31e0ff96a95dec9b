#include "nodes/seamless/TeSeamlessLists.h"

namespace {

/// Calls give(list, instance) for each list that a patch belongs to.
class ListsOfPatch {
public:
  ListsOfPatch(const TeSeamlessLayout& layout, bool whole) : m_layout(layout), m_whole(whole) {}

  std::size_t count() const {
    const std::size_t levels = std::size_t(m_layout.levels());
    return m_whole ? levels * levels * levels * levels : 4 * levels * (levels + 1);
  }

  template <class Give> void forEach(const TeSeamlessPatch& patch, const Give& give) const {
    const int levels = m_layout.levels();
    TeSeamlessInstance instance;
    instance.cellsLog = m_layout.cellsLog(patch.level);
    instance.column = patch.x << instance.cellsLog;
    instance.row = patch.y << instance.cellsLog;
    std::array<int, 4> indices{};
    for (std::size_t side = 0; side < 4; side++) {
      indices[side] = teDetailResolution(patch.detail[side]);
      instance.weights |= std::uint32_t(teDetailWeight(patch.detail[side])) << (8 * side);
    }
    if (m_whole) {
      std::size_t list = 0;
      for (const int index : indices)
        list = list * std::size_t(levels) + std::size_t(index);
      give(list, instance);
      return;
    }
    for (int side = 0; side < 4; side++) {
      const int a = indices[std::size_t(side)], b = indices[std::size_t((side + 1) % 4)];
      give(std::size_t(side * levels + a), instance);
      give(std::size_t((4 + side * levels + a) * levels + b), instance);
    }
  }

private:
  const TeSeamlessLayout& m_layout;
  bool m_whole;
};

} // namespace

void TeSeamlessLists::build(const TeSeamlessSelection& selection, const TeSeamlessLayout& layout,
                            const TeSeamlessParts& parts) {
  const ListsOfPatch lists(layout, parts.hasWholePatches());
  m_counts.assign(lists.count(), 0);
  for (const TeSeamlessPatch& patch : selection.patches)
    lists.forEach(patch, [&](std::size_t list, const TeSeamlessInstance&) { m_counts[list]++; });

  m_draws.clear();
  m_next = 0;
  if (parts.hasWholePatches())
    addPatchDraws(parts);
  else
    addPartDraws(parts);

  m_instances.resize(std::size_t(m_next));
  for (const TeSeamlessPatch& patch : selection.patches)
    lists.forEach(patch, [&](std::size_t list, const TeSeamlessInstance& instance) {
      m_instances[std::size_t(m_counts[list]++)] = instance;
    });
}

void TeSeamlessLists::addDraw(std::size_t list, TeSeamlessDraw draw) {
  std::int32_t& count = m_counts[list];
  draw.firstInstance = m_next;
  draw.instanceCount = count;
  if (count > 0 && draw.part.count > 0)
    m_draws.push_back(draw);
  m_next += count;
  count = draw.firstInstance;
}

void TeSeamlessLists::addPartDraws(const TeSeamlessParts& parts) {
  const int levels = parts.levels();
  TeSeamlessDraw draw;
  for (int side = 0; side < 4; side++) {
    draw.orientation = std::uint8_t(side);
    draw.indices = {};
    draw.kind = TeSeamlessDraw::Tile;
    for (int a = 0; a < levels; a++) {
      draw.indices[std::size_t(side)] = std::uint8_t(a);
      draw.part = parts.tile(side, a);
      addDraw(std::size_t(side * levels + a), draw);
    }
    draw.kind = TeSeamlessDraw::Strip;
    for (int a = 0; a < levels; a++)
      for (int b = 0; b < levels; b++) {
        draw.indices[std::size_t(side)] = std::uint8_t(a);
        draw.indices[std::size_t((side + 1) % 4)] = std::uint8_t(b);
        draw.part = parts.strip(side, a, b);
        addDraw(std::size_t((4 + side * levels + a) * levels + b), draw);
      }
  }
}

void TeSeamlessLists::addPatchDraws(const TeSeamlessParts& parts) {
  const std::size_t levels = std::size_t(parts.levels());
  TeSeamlessDraw draw;
  for (std::size_t list = 0; list < m_counts.size(); list++) {
    if (m_counts[list] == 0)
      continue;
    std::size_t rest = list;
    for (std::size_t side = 4; side-- > 0; rest /= levels)
      draw.indices[side] = std::uint8_t(rest % levels);
    draw.part = parts.patch(draw.indices);
    addDraw(list, draw);
  }
}
