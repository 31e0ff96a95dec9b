#include "generators/filters/TeBandSource.h"

#include "generators/base/TeHash.h"
#include "generators/filters/TeBandGrid.h"

#include <algorithm>
#include <optional>

namespace {

/// The input's job, then the map into a grid, the filter's units, and the grid into the map.
class BandJob final : public TeHeightJob {
public:
  BandJob(std::unique_ptr<TeHeightJob> input, float k, int passes)
      : m_input(std::move(input)), m_k(k), m_passes(passes) {}

protected:
  TeProgress unit() override {
    switch (m_stage) {
    case Stage::Input:
      return unitOfInput();
    case Stage::Load:
      m_grid->load(m_map, m_row, rowsOfUnit());
      if (advanceRow()) {
        m_grid->begin(m_k, m_passes);
        m_stage = Stage::Filter;
      }
      return TeProgress::Working;
    case Stage::Filter:
      if (!m_grid->unit())
        m_stage = Stage::Store;
      return TeProgress::Working;
    case Stage::Store:
      m_grid->store(m_map, m_row, rowsOfUnit());
      return advanceRow() ? TeProgress::Done : TeProgress::Working;
    }
    return TeProgress::Working;
  }

private:
  enum class Stage { Input, Load, Filter, Store };

  TeProgress unitOfInput() {
    TeAllowance one = TeAllowance::units(1);
    switch (m_input->step(one)) {
    case TeProgress::Working:
      break;
    case TeProgress::Failed:
      return fail(m_input->error());
    case TeProgress::Done:
      m_map = m_input->takeMap();
      m_input.reset();
      m_grid.emplace(m_map.width(), m_map.height());
      m_stage = Stage::Load;
      break;
    }
    return TeProgress::Working;
  }

  int rowsOfUnit() const {
    constexpr int kSamples = 32768;
    return std::min(std::max(1, kSamples / m_map.width()), m_map.height() - m_row);
  }

  /// True behind the last row, and back at the first.
  bool advanceRow() {
    m_row += rowsOfUnit();
    if (m_row < m_map.height())
      return false;
    m_row = 0;
    return true;
  }

  std::unique_ptr<TeHeightJob> m_input;
  float m_k;
  int m_passes;
  Stage m_stage = Stage::Input;
  std::optional<TeBandGrid> m_grid;
  int m_row = 0;
};

} // namespace

std::uint64_t TeBandSource::fingerprint() const {
  const std::uint64_t hash = teHashCombine(m_input->fingerprint(), teHashText("band"));
  return teHashCombine(teHashDouble(hash, double(m_k)), std::uint64_t(m_passes));
}

TeStatus TeBandSource::accepts(int columns, int rows) const {
  if (TeStatus ok = m_input->accepts(columns, rows); !ok)
    return ok;
  return TeBandGrid::accepts(columns, rows);
}

std::unique_ptr<TeHeightJob> TeBandSource::start(const TeMapRequest& request) const {
  return std::make_unique<BandJob>(m_input->start(request), m_k, m_passes);
}
