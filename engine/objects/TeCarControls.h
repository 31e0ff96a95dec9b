#pragma once

#include "engine/input/TeKeyState.h"

#include <cstdint>
#include <string>
#include <vector>

/// What a driver does with hands and feet, set by a program or by keys: arrows and W A S D, space.
struct TeCarControls {
  double throttle = 0; ///< -1 .. 1; against the motion it brakes, from rest it drives forward or in reverse
  double steering = 0; ///< -1 full left .. 1 full right
  bool handBrake = false;

  /// Takes a key; false if it means nothing to a driver. Two keys for the same count as one.
  bool handleEvent(const TeKeyEvent& event);
  /// All keys and pedals released.
  void release() { *this = TeCarControls(); }
  static std::vector<std::string> helpLines();

  bool anyKey() const { return m_keys.any(); }
  bool neutral() const { return throttle == 0 && steering == 0 && !handBrake; }
  /// Of what is steered by and of the keys that are held.
  std::uint64_t hash() const;

private:
  TeKeyState m_keys;
};
