#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/common/TeEngineApp.h"
#include "apps/common/TeEngineOptions.h"

/// Runs an application of the engine from its parsed command line to its end and gives the exit status: in a
/// window until it is closed (or for --frames N), or without one frame by frame into the final picture.
/// Records or replays, writes picture and report. Errors are one line on standard error.
///
///     extern "C" int teMain(int argc, char** argv) {
///       TeCommandLine commandLine("terrane-drive", "...");
///       TeEngineOptions options;
///       options.addTo(commandLine);
///       MyApp app; // its own options to commandLine.cli()
///       if (const std::optional<int> status = commandLine.parse(argc, argv))
///         return *status;
///       return teRunEngine(commandLine, options, app);
///     }
int teRunEngine(const TeCommandLine& commandLine, const TeEngineOptions& options, TeEngineApp& app);
