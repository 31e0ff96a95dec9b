#include "engine/jobs/TeJobState.h"

const char* teJobStateName(TeJobState state) {
  switch (state) {
  case TeJobState::Waiting:
    return "waiting";
  case TeJobState::SourceMaps:
    return "source maps";
  case TeJobState::Blend:
    return "blend";
  case TeJobState::Arrays:
    return "arrays";
  case TeJobState::Model:
    return "model";
  case TeJobState::Inserted:
    return "inserted";
  case TeJobState::Cancelled:
    return "cancelled";
  case TeJobState::Failed:
    break;
  }
  return "failed";
}
