#include "engine/objects/TeCarControls.h"

#include "engine/TeStateHash.h"

#include <algorithm>
#include <array>

namespace {

enum Meaning { Forward, Back, Left, Right, HandBrake, kMeanings };

struct Binding {
  SoKeyboardEvent::Key key;
  Meaning meaning;
};

constexpr std::array<Binding, 9> kBindings = {{{SoKeyboardEvent::UP_ARROW, Forward},
                                               {SoKeyboardEvent::W, Forward},
                                               {SoKeyboardEvent::DOWN_ARROW, Back},
                                               {SoKeyboardEvent::S, Back},
                                               {SoKeyboardEvent::LEFT_ARROW, Left},
                                               {SoKeyboardEvent::A, Left},
                                               {SoKeyboardEvent::RIGHT_ARROW, Right},
                                               {SoKeyboardEvent::D, Right},
                                               {SoKeyboardEvent::SPACE, HandBrake}}};

} // namespace

bool TeCarControls::handleEvent(const TeKeyEvent& event) {
  const auto bound = std::find_if(kBindings.begin(), kBindings.end(),
                                  [&](const Binding& binding) { return binding.key == event.key; });
  if (bound == kBindings.end())
    return false;
  m_keys.change(event);
  std::array<bool, kMeanings> held{};
  for (const Binding& binding : kBindings)
    if (m_keys.isDown(binding.key))
      held[binding.meaning] = true;
  throttle = double(held[Forward]) - double(held[Back]);
  steering = double(held[Right]) - double(held[Left]);
  handBrake = held[HandBrake];
  return true;
}

std::vector<std::string> TeCarControls::helpLines() {
  return {"Up, W      throttle", "Down, S    brake, from rest reverse", "Left, A    steer left",
          "Right, D   steer right", "Space      hand brake"};
}

std::uint64_t TeCarControls::hash() const {
  return teHashState(teHashDouble(teHashDouble(std::uint64_t(handBrake), throttle), steering), m_keys);
}
