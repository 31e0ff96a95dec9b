#pragma once

#include "nodes/lod/TeLodMethod.h"

#include <memory>
#include <string>
#include <vector>

/// All LOD methods, by name.
class TeLodMethods {
public:
  /// In the order in which reports list them.
  static const std::vector<std::string>& names();
  /// Error: a name that is none of them (the message lists those), a terrain that the method cannot have.
  static TeResult<std::unique_ptr<TeLodMethod>> create(const std::string& name, TeLodFieldPtr field);
};
