#pragma once

#include "generators/base/TeResult.h"

#include <string>

class SoNode;

/// Writes a scene as an Inventor file in text; floats with nine digits, so that reading gives the same bits.
/// Error: the file cannot be written; the message names it and says why.
TeStatus teWriteScene(SoNode* scene, const std::string& path);
