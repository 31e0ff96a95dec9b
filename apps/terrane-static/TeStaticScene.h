#pragma once

#include "apps/terrane-static/TeStaticOptions.h"
#include "nodes/TeNodePtr.h"
#include "nodes/terrain/TeStaticBlock.h"

#include <Inventor/nodes/SoSeparator.h>

/// A block with camera and sun: seen from the south-east, halfway up, or from straight above; wholly in view
/// at the given width / height. The sun stands low in the west, so that relief shows.
TeResult<TeNodePtr<SoSeparator>> teStaticScene(const TeStaticBlock& block, const TeStaticOptions& options,
                                               float aspect);
