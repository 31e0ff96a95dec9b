// A program without Coin: makes one patch of an endless world and asks for a height.
#include "generators/TeGeneratorRegistry.h"
#include "patchdb/TePatchDatabase.h"

#include <cstdio>

int main() {
  auto source = TeGeneratorRegistry::instance().source("faults", {"band"});
  if (!source) {
    std::fprintf(stderr, "%s\n", source.error().message.c_str());
    return 1;
  }
  TeWorld world;
  world.seed = 7;
  world.sources = std::make_shared<TeSingleSource>(*source);
  auto database = TePatchDatabase::create(world);
  if (!database || !(*database)->build({0, 0, 0})) {
    std::fprintf(stderr, "no patch\n");
    return 1;
  }
  const auto height = (*database)->heightAt({1.5, 2.5});
  if (!height) {
    std::fprintf(stderr, "no height\n");
    return 1;
  }
  std::printf("height %.9g\n", *height);
}
