// scene-bench [--context egl|osmesa] [Google Benchmark's options]

#include "bench/scene/benchContext.h"
#include "nodes/TeNodes.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>

extern "C" int teMain(int argc, char** argv) {
  TeContextKind kind = TeContextKind::Egl;
  for (int i = 1; i + 1 < argc; i++) {
    if (std::string(argv[i]) == "--context") {
      const TeResult<TeContextKind> named = teContextKind(argv[i + 1]);
      if (!named) {
        std::fprintf(stderr, "scene-bench: %s\n", named.error().message.c_str());
        return 2;
      }
      kind = *named;
    }
  }
  TeNodes::init();
  const auto made = TeContext::create(kind, 64, 64);
  if (!made) {
    std::fprintf(stderr, "scene-bench: %s\n", made.error().message.c_str());
    return 1;
  }
  benchContext = made->get();
  benchmark::AddCustomContext("renderer", benchContext->renderer());
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
