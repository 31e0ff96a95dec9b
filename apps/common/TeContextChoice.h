#pragma once

#include <cstdlib>
#include <cstring>

/// Which context a program's arguments ask for: the value of the last `--context NAME` or `--context=NAME`
/// before a lone `--`; without one "window" if there is a display, else "osmesa". The launcher decides by it
/// which OpenGL it loads, the application by the same rule which context it makes. The name is not checked.
inline const char* teContextChoice(int argc, char** argv) {
  const char* display = std::getenv("DISPLAY");
  const char* choice = display && *display ? "window" : "osmesa";
  for (int i = 1; i < argc && std::strcmp(argv[i], "--") != 0; i++) {
    if (std::strcmp(argv[i], "--context") == 0 && i + 1 < argc)
      choice = argv[++i];
    else if (std::strncmp(argv[i], "--context=", 10) == 0)
      choice = argv[i] + 10;
  }
  return choice;
}
