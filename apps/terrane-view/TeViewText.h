#pragma once

#include "apps/terrane-view/TeLodNodes.h"
#include "apps/terrane-view/TeViewPose.h"

#include <string>
#include <vector>

/// The statistics over the picture: of Seamless Patches the document's, error bound and equivalent precision;
/// those of each LOD terrain; and where the eye is. `frameSeconds` 0 = not shown.
std::vector<std::string> teViewLines(const TeLodNodes& nodes, const TeViewPose& pose, double frameSeconds);
/// Of a LOD terrain: its method, what the last frame was, how good it was, and what is wanted of it.
std::vector<std::string> teLodLines(const SoTeLodTerrain& node, const TeLodStatistics& figures);
/// Keys of the camera and of the program, in columns.
std::vector<std::string> teViewHelp();
