#pragma once

#include "engine/objects/TeCar.h"
#include "generators/TeGeneratorRegistry.h"
#include "patchdb/TePatchDatabase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/// A car on generated terrain, whose patches are built around it as it goes.
class TeTestRoad {
public:
  explicit TeTestRoad(const std::string& generator, double spacing = 1, int samples = 65,
                      const std::vector<std::string>& filters = {}) {
    const auto source = TeGeneratorRegistry::instance().source(generator, filters);
    EXPECT_TRUE(source) << (source ? "" : source.error().message);
    m_terrain = std::move(*TePatchDatabase::create(
        {*TeLattice::create(samples, spacing), 7, std::make_shared<TeSingleSource>(*source)}));
  }

  TeCar& car() { return m_car; }
  TePatchDatabase& terrain() { return *m_terrain; }

  void start(glm::dvec2 place, glm::dvec2 heading = {0, 1}) {
    EXPECT_TRUE(m_car.setPosition({place, 0}));
    // Half the way from north to the heading, as a quaternion about z.
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1 + heading.y)));
    const double sine = std::copysign(std::sqrt(std::max(0.0, 0.5 * (1 - heading.y))), -heading.x);
    EXPECT_TRUE(m_car.setOrientation(glm::dquat(cosine, 0, 0, sine)));
  }

  /// Updates the car in steps of dt, and measures after each.
  void drive(double seconds, double dt = 1.0 / 30) {
    const int steps = int(std::lround(seconds / dt));
    for (int i = 0; i < steps; ++i)
      step(dt);
  }

  void step(double dt) {
    buildAround(m_car.position());
    m_time += dt;
    m_car.update({dt, m_time, *m_terrain});
    measure();
  }

  void buildAround(glm::dvec2 place) {
    const double side = m_terrain->lattice().patchSide();
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const auto key = tePatchAt(m_terrain->lattice(), place + side * glm::dvec2(x, y));
        ASSERT_TRUE(key && m_terrain->build(*key));
      }
  }

  double worstGap = 0;    ///< metres between a wheel and the surface
  double worstTravel = 0; ///< metres
  int patchesVisited = 0;
  int frames = 0;

private:
  void measure() {
    ++frames;
    for (int i = 0; i < TeCarGeometry::kWheels; ++i) {
      const glm::dvec3 contact = m_car.wheelContact(i);
      const std::optional<double> ground = m_terrain->heightAt({contact.x, contact.y});
      worstGap = std::max(worstGap, ground ? std::fabs(contact.z - *ground) : INFINITY);
      worstTravel = std::max(worstTravel, std::fabs(m_car.travel(i)));
    }
    const auto key = tePatchAt(m_terrain->lattice(), m_car.position());
    if (key && std::find(m_visited.begin(), m_visited.end(), *key) == m_visited.end())
      m_visited.push_back(*key);
    patchesVisited = int(m_visited.size());
  }

  std::unique_ptr<TePatchDatabase> m_terrain;
  TeCar m_car{"car"};
  double m_time = 0;
  std::vector<TePatchKey> m_visited;
};
