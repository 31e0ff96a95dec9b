#pragma once

#include "apps/common/TeCommonOptions.h"
#include "apps/common/TeReport.h"
#include "generators/base/TeResult.h"

class SoNode;

/// Draws the scene as the common options say: in an examiner viewer until it is closed, or into pictures, the
/// last of which is written. Adds context, frames and times to the report.
TeStatus teDrawStatic(SoNode* scene, const TeCommonOptions& options, TeReport& report);
