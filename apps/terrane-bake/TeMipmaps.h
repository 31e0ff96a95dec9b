#pragma once

#include "apps/common/TeCommonOptions.h"
#include "apps/common/TeReport.h"
#include "apps/terrane-bake/TeMipmapsOptions.h"

#include <string>

/// The command `mipmaps`: a pyramid of an elevation file or a picture. Returns the application's exit status,
/// after a line on standard error if that is no success.
int teBakeMipmaps(const std::string& application, const TeMipmapsOptions& options,
                  const TeCommonOptions& common, TeReport& report);
