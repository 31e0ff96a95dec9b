#pragma once

#include "generators/TeHeightSource.h"
#include "generators/elevation/TeElevationFile.h"

/// What a look at every post of a file tells; metres.
struct TeElevationSummary {
  float minimum = 0; ///< 0 if every post is missing
  float maximum = 0;
  int highestColumn = 0; ///< of the highest posts the one in the first row, there in the first column
  int highestRow = 0;
  std::int64_t present = 0;
  std::int64_t missing = 0;
};

/// The look at every post of a file, in slices; one unit of work is one tile. Voids are filled first if the
/// file is opened so. Not thread-safe.
class TeElevationScan {
public:
  static constexpr std::int64_t kMaxPosts = std::int64_t(1) << 28;

  explicit TeElevationScan(TeElevationFilePtr file) : m_file(std::move(file)) {}

  /// Failed: the file cannot be read, or has more than kMaxPosts posts.
  TeProgress step(TeAllowance& allowance);
  const TeError& error() const { return m_error; }
  /// Only after Done.
  const TeElevationSummary& summary() const { return m_summary; }

  /// All at once.
  static TeResult<TeElevationSummary> summarise(TeElevationFilePtr file);

private:
  TeProgress unit();
  void add(const TeElevationTile& tile);

  TeElevationFilePtr m_file;
  TeElevationSummary m_summary;
  TeError m_error;
  TeProgress m_progress = TeProgress::Working;
  int m_across = 0;
  int m_down = 0;
};
