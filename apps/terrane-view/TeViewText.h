#pragma once

#include "apps/terrane-view/TeSeamlessNodes.h"
#include "apps/terrane-view/TeViewPose.h"

#include <string>
#include <vector>

/// The statistics over the picture: the document's, error bound and equivalent precision, and where the eye
/// is. `frameSeconds` 0 = not shown.
std::vector<std::string> teViewLines(const TeSeamlessNodes& nodes, const TeViewPose& pose,
                                     double frameSeconds);
/// Keys of the camera and of the program, in columns.
std::vector<std::string> teViewHelp();
