#pragma once

#include <string>

/// Sends what the libraries say through TeLog to standard error by way of spdlog, under the application's
/// name. Quiet: errors only.
void teStartAppLog(const std::string& application, bool quiet);

/// Whether this was the last error that the libraries have said: then the user has read it already.
bool teWasLogged(const std::string& error);
