#pragma once

#include "generators/TeFilter.h"
#include "generators/TeGenerator.h"

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

/// Generators and filters by name: how apps, nodes and files name them, and how a program adds its own
/// without touching ours. Thread-safe.
///
/// A *specification* is `name` or `name:parameter=value,parameter=value`; a value that contains a comma or a
/// blank is written in double quotes ("" inside them stands for one quote). Examples:
/// `faults:faults=80,profile=smooth`, `band:k=0.8,passes=2`, `function:z="20*min(sin(x/50), cos(y/50))"`.
/// Parameters that are not given have their defaults. Errors are one line that names what was given and what
/// is possible.
class TeGeneratorRegistry {
public:
  /// What makes a world where nobody chose: fault formation that needs no filter, so that it can be evaluated
  /// at scattered points.
  static constexpr const char* kDefaultGenerator = "faults:profile=smooth";

  using GeneratorFactory = std::function<std::unique_ptr<TeGenerator>()>;
  using FilterFactory = std::function<std::unique_ptr<TeFilter>()>;

  /// The registry with all of our own generators and filters (TeBuiltInGenerators.cpp).
  static TeGeneratorRegistry& instance();
  /// An empty registry.
  TeGeneratorRegistry() = default;

  /// Error if the name is taken (generators and filters share one space of names), is not made of lower-case
  /// letters, digits and '-', or the factory is empty. The factory is called with no lock held.
  TeStatus addGenerator(const std::string& name, const std::string& help, GeneratorFactory factory);
  TeStatus addFilter(const std::string& name, const std::string& help, FilterFactory factory);

  /// In order of registration.
  std::vector<std::string> generatorNames() const;
  std::vector<std::string> filterNames() const;
  /// The one-line help of a generator or filter; empty if there is none of that name.
  std::string help(std::string_view name) const;
  /// All generators and filters with their parameters, defaults, ranges and help, for `--help`.
  std::string helpText() const;

  /// A generator or filter with the parameters of the specification.
  TeResult<std::unique_ptr<TeGenerator>> generator(std::string_view specification) const;
  TeResult<std::unique_ptr<TeFilter>> filter(std::string_view specification) const;
  /// A generator with filters over it, in order, as one generator; the generator itself if there are none.
  TeResult<std::unique_ptr<TeGenerator>> chain(std::string_view generator,
                                               const std::vector<std::string>& filters) const;
  /// A source with filters over it, in order, each by specification.
  TeResult<TeHeightSourcePtr> filtered(TeHeightSourcePtr source,
                                       const std::vector<std::string>& filters) const;
  /// The immutable source of chain().
  TeResult<TeHeightSourcePtr> source(std::string_view generator,
                                     const std::vector<std::string>& filters = {}) const;

private:
  struct Entry {
    std::string name;
    std::string help;
    GeneratorFactory generator; ///< exactly one of the two
    FilterFactory filter;
  };
  TeStatus add(Entry entry);
  std::vector<Entry> entries() const;

  mutable std::mutex m_mutex;
  std::vector<Entry> m_entries;
};

/// The specification that makes a generator or filter with these parameters again.
std::string teSpecification(std::string_view name, const TeParameters& parameters);
