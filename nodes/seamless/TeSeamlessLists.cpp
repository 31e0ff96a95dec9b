#include "nodes/seamless/TeSeamlessLists.h"

#include <algorithm>

namespace {

/// Calls give(list, instance) for the eight parts of a patch; lists are tiles by side and index, then strips.
template <class Give>
void forEachPart(const TeSeamlessPatch& patch, const TeSeamlessLayout& layout, const Give& give) {
  const int levels = layout.levels();
  const int cellsLog = layout.cellsLog(patch.level);
  TeSeamlessInstance instance;
  instance.column = patch.x << cellsLog;
  instance.row = patch.y << cellsLog;
  instance.cellsLog = std::uint8_t(cellsLog);
  const auto heightLevel = [&](int index) {
    return std::uint8_t(layout.resolutionLog() - layout.spacingLog(patch.level, index));
  };
  for (int side = 0; side < 4; side++) {
    const float first = patch.detail[std::size_t(side)];
    const float second = patch.detail[std::size_t((side + 1) % 4)];
    const int a = teDetailResolution(first);
    const int b = teDetailResolution(second);
    instance.weightFirst = teDetailWeight(first);
    instance.weightSecond = teDetailWeight(second);
    instance.heightLevel = heightLevel(a);
    give(side * levels + a, instance);
    instance.heightLevel = heightLevel(std::max(a, b));
    give((4 + side * levels + a) * levels + b, instance);
  }
}

} // namespace

void TeSeamlessLists::build(const TeSeamlessSelection& selection, const TeSeamlessLayout& layout,
                            const TeSeamlessParts& parts) {
  const int levels = layout.levels();
  m_counts.assign(std::size_t(4 * levels * (levels + 1)), 0);
  for (const TeSeamlessPatch& patch : selection.patches)
    forEachPart(patch, layout, [&](int list, const TeSeamlessInstance&) { m_counts[std::size_t(list)]++; });

  m_draws.clear();
  std::int32_t start = 0;
  const auto addDraw = [&](int list, TeSeamlessDraw draw) {
    std::int32_t& count = m_counts[std::size_t(list)];
    draw.firstInstance = start;
    draw.instanceCount = count;
    if (count > 0 && draw.part.count > 0)
      m_draws.push_back(draw);
    start += count;
    count = draw.firstInstance; // from here on where the next instance goes
  };
  for (int side = 0; side < 4; side++)
    for (int a = 0; a < levels; a++)
      addDraw(side * levels + a,
              {parts.tile(side, a), false, std::uint8_t(side), std::uint8_t(a), std::uint8_t(a), 0, 0});
  for (int side = 0; side < 4; side++)
    for (int a = 0; a < levels; a++)
      for (int b = 0; b < levels; b++)
        addDraw((4 + side * levels + a) * levels + b,
                {parts.strip(side, a, b), true, std::uint8_t(side), std::uint8_t(a), std::uint8_t(b), 0, 0});

  m_instances.resize(std::size_t(start));
  for (const TeSeamlessPatch& patch : selection.patches)
    forEachPart(patch, layout, [&](int list, const TeSeamlessInstance& instance) {
      m_instances[std::size_t(m_counts[std::size_t(list)]++)] = instance;
    });
}
