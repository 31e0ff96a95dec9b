#pragma once

#include "generators/base/TeResult.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/nodes/SoSeparator.h>

#include <string>

/// Reads an Inventor file of any kind that Coin reads, under one separator. Error: one line that names the
/// file, and the reason and the line as Coin tells them.
TeResult<TeNodePtr<SoSeparator>> teReadScene(const std::string& path);
