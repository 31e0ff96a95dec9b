#pragma once

#include "nodes/lod/lodNode.h"

#include <cctype>
#include <cstdint>
#include <string>
#include <vector>

/// The SoTeSeamlessPatches among shapes that are named after their LOD method.
constexpr const char* kPatches = "TeSeamlessPatches";

/// Hills on a square of 1000 metres around (0, 0).
inline TeNodePtr<SoTeLodShape> lodShape(const std::string& name, int resolution = 256) {
  return name == kPatches ? TeNodePtr<SoTeLodShape>(hillsNode(resolution).get())
                          : TeNodePtr<SoTeLodShape>(lodNode(name, resolution).get());
}

inline std::vector<std::string> lodShapeNames() {
  std::vector<std::string> names = TeLodMethods::names();
  names.push_back(kPatches);
  return names;
}

/// Names that GoogleTest takes, of a test's parameters.
inline std::string testName(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& letter : name)
    letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
  return name;
}

/// What the statistics of both classes tell.
struct LodShapeStatistics {
  std::int64_t triangles, drawCalls, bytesUploaded;
  double selectionSeconds;
};

inline LodShapeStatistics statisticsOf(const SoTeLodShape& shape) {
  if (const auto* patches = dynamic_cast<const SoTeSeamlessPatches*>(&shape)) {
    const TeSeamlessStatistics& s = patches->statistics();
    return {s.faces, s.drawCalls, s.bytesUploaded, s.selectionSeconds};
  }
  const TeLodStatistics& s = dynamic_cast<const SoTeLodTerrain&>(shape).statistics();
  return {s.triangles, s.drawCalls, s.bytesUploaded, s.selectionSeconds};
}
