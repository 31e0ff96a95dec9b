#pragma once

#include "nodes/TePicture.h"

#include <string>

/// Writes a picture that the user has asked for as the next free NAME-001.png, NAME-002.png, … of a folder,
/// and says so through TeLog; or why not.
void teSaveScreenshot(const TeResult<TePicture>& picture, const std::string& folder, const std::string& name);
