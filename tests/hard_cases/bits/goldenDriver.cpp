// Prints the hash of every registered generator and filter in the form of goldenHashes.h. With an argument it
// says which differ instead and returns 1 if any does. Built by bits.sh with several compilers and options.
#include "tests/hard_cases/generators/TeGoldenHashes.h"

#include <cinttypes>
#include <cstdio>

int main(int argc, char**) {
  int wrong = 0;
  int right = 0;
  for (const TeChainUnderTest& chain : teEveryGenerator()) {
    const std::uint64_t hash = teHashOf(chain);
    if (argc < 2) {
      std::printf("{\"%s\", 0x%016" PRIX64 "},\n", chain.name().c_str(), hash);
      continue;
    }
    const bool equal = hash != 0 && hash == teGoldenHashOf(chain);
    (equal ? right : wrong) += 1;
    if (!equal)
      std::printf("%s: 0x%016" PRIX64 ", golden 0x%016" PRIX64 "\n", chain.name().c_str(), hash,
                  teGoldenHashOf(chain));
  }
  if (argc >= 2)
    std::printf("%d generators and chains have their golden bits, %d differ\n", right, wrong);
  return wrong ? 1 : 0;
}
