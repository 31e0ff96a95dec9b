#pragma once

#include "generators/base/TeResult.h"

#include <string>

class SoNode;

/// Writes a scene as an Inventor file in text; numbers with as many digits as reading needs to give the same
/// bits.
/// Error: the file cannot be written; the message names it and says why.
TeStatus teWriteScene(SoNode* scene, const std::string& path);

/// Path of a file that a scene names: relative names mean beside the scene's own file, which is in `folder`
/// (empty: not known, the working folder). An empty name stays empty.
std::string teBesideScene(const std::string& file, const std::string& folder);
