#include "apps/terrane-bake/TeResampledRows.h"

#include <algorithm>
#include <cmath>
#include <limits>

TeResampledRows::TeResampledRows(std::unique_ptr<TeRows> source, int side, std::optional<double> outside)
    : m_source(std::move(source)), m_outside(outside.value_or(std::numeric_limits<double>::quiet_NaN())) {
  m_columns = m_rows = side;
  m_channels = m_source->channels();
  m_step = double(std::max(m_source->columns(), m_source->rows()) - 1) / (side - 1);
  for (int column = 0; column < side; ++column)
    m_places.push_back(place(column, m_source->columns()));
}

TeResampledRows::Place TeResampledRows::place(int index, int posts) const {
  const double beside = 0.5 * (std::max(m_source->columns(), m_source->rows()) - posts);
  const double at = index * m_step - beside;
  constexpr double kSlack = 1e-6;
  if (at < -kSlack || at > posts - 1 + kSlack)
    return {};
  const double whole = std::floor(at + 0.5);
  const double inside = std::clamp(std::fabs(at - whole) < kSlack ? whole : at, 0.0, double(posts - 1));
  return {int(inside), inside - int(inside)};
}

TeStatus TeResampledRows::sourceRow(int row, const double*& numbers) {
  std::vector<double>& held = m_held[row & 1];
  if (m_heldRows[row & 1] != row) {
    held.resize(std::size_t(m_source->columns()) * std::size_t(m_channels));
    m_heldRows[row & 1] = -1;
    if (TeStatus ok = m_source->read(row, held.data()); !ok)
      return ok;
    m_heldRows[row & 1] = row;
  }
  numbers = held.data();
  return {};
}

TeStatus TeResampledRows::read(int row, double* numbers) {
  const Place down = place(row, m_source->rows());
  if (down.post < 0) {
    std::fill(numbers, numbers + std::size_t(m_columns) * m_channels, m_outside);
    return {};
  }
  const double* north = nullptr;
  const double* south = nullptr;
  if (TeStatus ok = sourceRow(down.post, north); !ok)
    return ok;
  if (TeStatus ok = sourceRow(down.fraction > 0 ? down.post + 1 : down.post, south); !ok)
    return ok;
  const auto between = [](double a, double b, double f) { return f > 0 ? (1 - f) * a + f * b : a; };
  for (int column = 0; column < m_columns; ++column) {
    const Place across = m_places[std::size_t(column)];
    for (int channel = 0; channel < m_channels; ++channel) {
      double& number = numbers[std::size_t(column) * m_channels + channel];
      number = m_outside;
      if (across.post < 0)
        continue;
      const std::size_t west = std::size_t(across.post) * m_channels + channel;
      const std::size_t east = across.fraction > 0 ? west + m_channels : west;
      number = between(between(north[west], north[east], across.fraction),
                       between(south[west], south[east], across.fraction), down.fraction);
    }
  }
  return {};
}
