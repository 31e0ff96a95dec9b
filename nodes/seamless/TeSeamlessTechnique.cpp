#include "nodes/seamless/TeSeamlessTechnique.h"

namespace {

constexpr const char* kHeights[] = {"Flat", "Heightmap", "Clipmaps"};
constexpr const char* kColours[] = {"Color", "Texture", "Detailmaps", "Slope"};

} // namespace

std::string TeSeamlessTechnique::name() const {
  return std::string(kHeights[heights]) + kColours[colours] + (instanced ? "Instanced" : "Classic");
}

TeResult<TeSeamlessTechnique> TeSeamlessTechnique::named(const std::string& name) {
  for (const TeSeamlessTechnique& technique : all())
    if (technique.name() == name)
      return technique;
  return TeError{"seamless patches: no technique \"" + name + "\"; an example is " +
                 TeSeamlessTechnique{Clipmaps, Texture, true}.name()};
}

std::vector<TeSeamlessTechnique> TeSeamlessTechnique::all() {
  std::vector<TeSeamlessTechnique> techniques;
  const auto add = [&](Colours first, Colours last) {
    for (const Heights heights : {Flat, Heightmap, Clipmaps})
      for (int colours = first; colours <= last; colours++)
        for (const bool instanced : {false, true})
          techniques.push_back({heights, Colours(colours), instanced});
  };
  add(Color, Detailmaps);
  add(Slope, Slope);
  return techniques;
}
