#pragma once

#include "nodes/lod/TeLodMethod.h"

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_set>

/// A LOD method as it is measured: by its name in options and tables, "seamless" or, with its vertices
/// morphed, "seamless-geomorph".
class TeLodCandidate {
public:
  /// `layout`: "LOWEST/LEVELS" of Seamless Patches; others do not look at it. Error: a name that is none, a
  /// method that cannot morph, a layout that does not fit the terrain.
  static TeResult<TeLodCandidate> create(const std::string& name, const std::string& layout,
                                         TeLodFieldPtr field);
  /// Empty if methods may be called so; else what is wrong, for options.
  static std::string checkName(const std::string& name);
  static std::string morphedName(const std::string& name) { return name + "-geomorph"; }

  const std::string& name() const { return m_name; }
  const std::string& layout() const { return m_layout; } ///< empty if the method has none
  bool geomorph() const { return m_geomorph; }
  TeLodMethod& method() const { return *m_method; }
  /// False: it draws everything, however accurate it is to be.
  bool hasDial() const { return !m_method->dial().name.empty(); }

  void select(const TeLodView& view, TeLodAccuracy accuracy);
  const TeLodSelection& selection() const { return m_method->selection(); }
  /// Of the last selection: lists of equal patches of Seamless Patches, else parts.
  std::int64_t drawCalls() const;
  /// Vertices of 12 bytes and indices of 4 of those parts of the last selection that are not among `known`,
  /// by their keys; of Seamless Patches the instances of all, as the rest is on the GPU.
  std::int64_t uploadBytes(const std::unordered_set<std::uint64_t>& known) const;

private:
  std::string m_name;
  std::string m_layout;
  bool m_geomorph = false;
  std::unique_ptr<TeLodMethod> m_method;
};
