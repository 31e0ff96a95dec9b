#pragma once

#include <string>

/// Sends what the libraries say through TeLog to standard error by way of spdlog, under the application's
/// name. Quiet: errors only.
void teStartAppLog(const std::string& application, bool quiet);
