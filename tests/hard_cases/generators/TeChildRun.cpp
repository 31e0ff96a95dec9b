#include "hard_cases/generators/TeChildRun.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>

TeChildRun TeChildRun::of(const std::function<int()>& work, double limit) {
  TeChildRun run;
  std::fflush(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    try {
      _exit(work());
    } catch (...) {
      _exit(101);
    }
  }
  int status = 0;
  rusage usage{};
  for (;;) {
    const pid_t ended = wait4(child, &status, WNOHANG, &usage);
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (ended != 0)
      break;
    if (run.seconds > limit)
      kill(child, SIGKILL);
    usleep(run.seconds < 0.05 ? 200 : 5000);
  }
  run.peakKilobytes = usage.ru_maxrss;
  if (WIFEXITED(status))
    run.status = WEXITSTATUS(status);
  else if (WIFSIGNALED(status))
    run.signal = WTERMSIG(status);
  return run;
}
