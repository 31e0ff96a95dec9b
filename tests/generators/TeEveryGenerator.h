#pragma once

#include <ostream>
#include <string>
#include <vector>

/// A generator with filters over it, by specification.
struct TeChainUnderTest {
  std::string generator;
  std::vector<std::string> filters;

  /// A name for tests: letters, digits and '_'.
  std::string name() const;
};

void PrintTo(const TeChainUnderTest& chain, std::ostream* out);

/// Every registered generator by itself (`elevation` over a small file that is written for it), and every
/// registered filter over one generator that fits and one that does not. So laws stated for all of these hold
/// for generators to come as well.
std::vector<TeChainUnderTest> teEveryGenerator();
