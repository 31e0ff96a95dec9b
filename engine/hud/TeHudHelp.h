#pragma once

#include <string>
#include <vector>

class TeCameraRig;
class TeObject;

/// The HUD's help: what the keys of the active object, the camera, the engine and the program do. A line is
/// keys, two spaces or more, and their meaning; meanings are put below each other.
std::vector<std::string> teHudHelp(const TeObject& object, const TeCameraRig& rig,
                                   const std::vector<std::string>& program);
