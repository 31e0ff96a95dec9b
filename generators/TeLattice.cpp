#include "generators/TeLattice.h"

#include <cmath>
#include <string>

TeResult<TeLattice> TeLattice::create(int samples, double spacing) {
  if (samples < kMinSamples || samples > kMaxSamples || samples % 2 == 0)
    return TeError{"samples: " + std::to_string(samples) + " is not an odd number from " +
                   std::to_string(kMinSamples) + " to " + std::to_string(kMaxSamples)};
  if (!(spacing > 0) || !std::isfinite(spacing))
    return TeError{"spacing: " + std::to_string(spacing) + " is not a positive number of metres"};
  TeLattice lattice;
  lattice.m_samples = samples;
  lattice.m_spacing = spacing;
  return lattice;
}

// Twice the distance in half cells is an integer, so the only roundings are the conversion and one product.
double TeLattice::position(std::int64_t sample) const {
  return double(2 * sample - cells()) * (0.5 * m_spacing);
}

std::int64_t TeLattice::sampleBelow(double position, double& fraction) const {
  const double cell = position / m_spacing + 0.5 * cells();
  std::int64_t below = std::int64_t(std::floor(cell));
  // The quotient is rounded: settle the cell by the positions that samples really have.
  if (this->position(below) > position)
    --below;
  else if (this->position(below + 1) <= position)
    ++below;
  const double west = this->position(below);
  fraction = (position - west) / (this->position(below + 1) - west);
  if (!(fraction < 1.0))
    fraction = std::nextafter(1.0, 0.0);
  return below;
}
