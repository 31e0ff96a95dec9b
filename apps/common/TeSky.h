#pragma once

#include <Inventor/SbColor.h>

class SoNode;
class SoPerspectiveCamera;

/// A sky from the horizon's colour, below it too, to blue overhead, seen with the directions of a camera from
/// wherever that is. To be drawn before the scene; writes no depth.
SoNode* teSky(SoPerspectiveCamera& camera, const SbColor& horizon);
