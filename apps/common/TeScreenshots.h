#pragma once

#include "apps/common/TeCommonOptions.h"
#include "apps/common/TeReport.h"

#include <string>

/// Writes a picture that the user has asked for as the next free NAME-001.png, NAME-002.png, … of a folder,
/// and says so through TeLog; or why not.
void teSaveScreenshot(const TeResult<TePicture>& picture, const std::string& folder, const std::string& name);
/// Adds the last frame's picture to the report, and writes it if the options ask for that; without pixels it
/// is none. Error: a file that cannot be written.
TeStatus teKeepPicture(const TePicture& picture, const TeCommonOptions& common, TeReport& report);
