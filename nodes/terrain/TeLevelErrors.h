#pragma once

#include "generators/TeHeightMap.h"
#include "generators/base/TeAllowance.h"
#include "nodes/terrain/TeGridLevels.h"
#include "patchdb/TePatchMesh.h"

#include <memory>
#include <vector>

/// Finds how far each level of a whole grid is from all its samples, in slices. Any slicing gives the same
/// errors.
class TeLevelErrors {
public:
  static constexpr std::size_t kTrianglesPerUnit = 1024;

  /// `levels` are those of the mesh's columns and rows.
  TeLevelErrors(const TePatchMesh& mesh, std::shared_ptr<const TeGridLevels> levels);

  /// Looks at triangles until the allowance is spent, at least one unit; true when done.
  bool step(TeAllowance& allowance);
  /// Once done: by level, from 0 on, the largest vertical deviation of a sample in metres; exact but rounded
  /// up. Level 0 has none.
  std::vector<float> take() { return std::move(m_errors); }

private:
  std::shared_ptr<const TeGridLevels> m_levels;
  TeHeightMap m_heights;
  std::vector<float> m_errors;
  int m_level = 1;        ///< in work
  std::size_t m_next = 0; ///< index of it
};
