#include "nodes/context/TeContextKind.h"

const char* teContextName(TeContextKind kind) {
  switch (kind) {
  case TeContextKind::Window:
    return "window";
  case TeContextKind::Egl:
    return "egl";
  case TeContextKind::OsMesa:
    return "osmesa";
  }
  return "";
}

TeResult<TeContextKind> teContextKind(std::string_view name) {
  for (TeContextKind kind : {TeContextKind::Window, TeContextKind::Egl, TeContextKind::OsMesa}) {
    if (name == teContextName(kind))
      return kind;
  }
  return TeError{"context '" + std::string(name) + "' is not one of window, egl, osmesa"};
}
