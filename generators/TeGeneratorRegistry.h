#pragma once

#include "generators/TeGenerator.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Generators and filters by name: how apps, nodes and files name them, and how a program adds its own
/// without touching ours. Thread-safe.
///
/// A *specification* is `name` or `name:parameter=value,parameter=value`; a value that contains a comma or a
/// blank is written in double quotes. Examples: `faults:faults=80,profile=smooth`, `band:k=0.8,passes=2`.
class TeGeneratorRegistry {
public:
  using GeneratorFactory = std::function<std::unique_ptr<TeGenerator>()>;

  /// The registry with all of our own generators and filters.
  static TeGeneratorRegistry& instance();

  /// Error if the name is taken or is not made of lower-case letters, digits and '-'.
  TeStatus add(const std::string& name, const std::string& help, GeneratorFactory factory);
  std::vector<std::string> names() const;
  std::string help(const std::string& name) const;

  /// A generator with the parameters of the specification.
  TeResult<std::unique_ptr<TeGenerator>> create(std::string_view specification) const;
  /// An immutable source: generator, then filters in order, each by specification.
  TeResult<TeHeightSourcePtr> source(std::string_view generator,
                                     const std::vector<std::string>& filters = {}) const;

private:
  TeGeneratorRegistry();
  struct Entry;
  std::vector<Entry> m_entries;
};
