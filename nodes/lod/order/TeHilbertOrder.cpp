#include "nodes/lod/order/TeHilbertOrder.h"

#include <algorithm>
#include <utility>

std::uint32_t TeHilbertOrder::along(std::uint32_t x, std::uint32_t y) {
  std::uint32_t distance = 0;
  for (std::uint32_t half = 1U << 15; half > 0; half >>= 1) {
    const bool east = (x & half) != 0, north = (y & half) != 0;
    // Quarters: south-west, north-west, north-east, south-east.
    distance = distance << 2 | (east ? (north ? 2U : 3U) : (north ? 1U : 0U));
    // The first and the last quarter are curves mirrored along a diagonal.
    if (!north) {
      if (east) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return distance;
}

std::vector<std::int32_t> TeHilbertOrder::create(const std::vector<TeLodVertex>& vertices,
                                                 const std::vector<std::uint32_t>& indices) {
  std::vector<std::int32_t> order(indices.size() / 3);
  if (order.empty())
    return order;
  std::int32_t west = vertices[indices[0]].column, east = west, south = vertices[indices[0]].row,
               north = south;
  for (const std::uint32_t index : indices) {
    west = std::min(west, vertices[index].column);
    east = std::max(east, vertices[index].column);
    south = std::min(south, vertices[index].row);
    north = std::max(north, vertices[index].row);
  }
  const double scale = 65535.0 / (3.0 * std::max({1, east - west, north - south}));
  std::vector<std::pair<std::uint32_t, std::int32_t>> places(order.size());
  for (std::size_t i = 0; i < places.size(); i++) {
    std::int64_t x = 0, y = 0;
    for (std::size_t corner = 0; corner < 3; corner++) {
      x += vertices[indices[3 * i + corner]].column - west;
      y += vertices[indices[3 * i + corner]].row - south;
    }
    places[i] = {along(std::uint32_t(scale * double(x)), std::uint32_t(scale * double(y))), std::int32_t(i)};
  }
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < order.size(); i++)
    order[i] = places[i].second;
  return order;
}
