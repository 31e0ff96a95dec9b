#pragma once

#include "apps/common/TeCommonOptions.h"
#include "apps/common/TeReport.h"
#include "apps/terrane-bake/TeSynthOptions.h"

#include <string>

/// The command `synth`: a RAW file with a description beside it. Returns the application's exit status, after
/// a line on standard error if that is no success.
int teBakeSynth(const std::string& application, const TeSynthOptions& options, const TeCommonOptions& common,
                TeReport& report);
