#pragma once

#include <Inventor/SbColor.h>

class SoNode;

/// Haze for what follows in the scene, which hides everything from a distance on: an SoEnvironment, but the
/// air near the eye is clear, for which Inventor has no field.
SoNode* teHaze(const SbColor& colour, float visibility);
