#include "engine/jobs/TeJobKind.h"

const char* teJobKindName(TeJobKind kind) {
  switch (kind) {
  case TeJobKind::Ground:
    return "ground";
  case TeJobKind::Block:
    return "block";
  case TeJobKind::Ahead:
    return "ahead";
  case TeJobKind::Other:
    break;
  }
  return "other";
}
