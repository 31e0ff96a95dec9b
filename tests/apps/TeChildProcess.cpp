#include "apps/TeChildProcess.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>

namespace {

[[noreturn]] void become(const std::vector<std::string>& command, const std::vector<std::string>& with,
                         const std::vector<std::string>& without, int output, int error) {
  dup2(output, STDOUT_FILENO);
  dup2(error, STDERR_FILENO);
  for (const std::string& name : without)
    unsetenv(name.c_str());
  for (const std::string& pair : with)
    putenv(const_cast<char*>(pair.c_str()));
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

} // namespace

int TeChildResult::errorLines() const { return int(std::count(error.begin(), error.end(), '\n')); }

TeChildResult teRunChild(const std::vector<std::string>& command, double seconds,
                         const std::vector<std::string>& with, const std::vector<std::string>& without) {
  TeChildResult result;
  int output[2], error[2];
  if (pipe(output) != 0 || pipe(error) != 0)
    return result;
  const pid_t child = fork();
  if (child == 0)
    become(command, with, without, output[1], error[1]);
  close(output[1]);
  close(error[1]);

  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::array<pollfd, 2> pipes = {pollfd{output[0], POLLIN, 0}, pollfd{error[0], POLLIN, 0}};
  bool killed = false;
  for (int open = 2; open > 0;) {
    if (!killed && std::chrono::steady_clock::now() > end)
      killed = kill(child, SIGKILL) == 0;
    poll(pipes.data(), pipes.size(), 100);
    for (std::size_t i = 0; i < pipes.size(); ++i) {
      if (pipes[i].fd < 0 || pipes[i].revents == 0)
        continue;
      std::array<char, 4096> buffer;
      const ssize_t got = read(pipes[i].fd, buffer.data(), buffer.size());
      if (got > 0) {
        (i == 0 ? result.output : result.error).append(buffer.data(), std::size_t(got));
      } else {
        close(pipes[i].fd);
        pipes[i].fd = -1;
        --open;
      }
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}
