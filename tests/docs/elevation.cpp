// Examples of docs/elevation-data.md.

#include "generators/elevation/TeElevationGenerator.h"
#include "generators/elevation/TeElevationScan.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

/// 33×33 posts, a valley between two slopes, as headerless 16 bit data; removed in the end.
class ValleyFile {
public:
  ValleyFile() : m_path((std::filesystem::temp_directory_path() / "terrane-valley.raw").string()) {
    std::ofstream out(m_path, std::ios::binary);
    for (int row = 0; row < 33; ++row)
      for (int column = 0; column < 33; ++column) {
        const int height = 500 + 10 * std::abs(column - 16);
        out.put(char(height & 255)).put(char(height >> 8));
      }
  }
  ~ValleyFile() { std::filesystem::remove(m_path); }
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

} // namespace

TEST(DocsElevation, Generator) {
  const ValleyFile valley;
  //! [generator]
  TeElevationGenerator elevation;
  elevation.file = valley.path();
  elevation.encoding = "raw";
  elevation.rawSize = "33x33";
  elevation.posts = 30;
  elevation.outside = "clamp";
  TeStatus status = elevation.updateParams();

  const TeElevationFilePtr file = elevation.elevationFile();
  const TeResult<double> spacing = file->coveringSpacing(3, 65);
  const TeResult<TeLattice> lattice = TeLattice::create(65, *spacing);
  const TeResult<TeHeightMap> map =
      elevation.source()->generate(TeMapRequest::sourceMap(*lattice, 0, {0, 0}));
  //! [generator]
  ASSERT_TRUE(status);
  EXPECT_EQ(*spacing, 960.0 / (3 * 32));
  EXPECT_EQ(map->statistics().missing, 0);
}

TEST(DocsElevation, File) {
  const ValleyFile valley;
  TeElevationOptions options;
  options.encoding = TeElevationEncoding::Raw;
  options.rawColumns = options.rawRows = 33;
  //! [file]
  const TeResult<TeElevationFilePtr> opened = TeElevationFile::open(valley.path(), options);
  const TeElevationFile& file = **opened;
  const TeLocalExtent& extent = file.extent();
  const TeResult<float> corner = file.post(0, 0);
  const TeResult<TeElevationSummary> summary = TeElevationScan::summarise(*opened);
  const TeResult<TeGeographicPosition> place = file.toGeographic({extent.west, extent.north});
  //! [file]
  EXPECT_EQ(extent.width(), 32);
  EXPECT_EQ(*corner, 660);
  EXPECT_EQ(summary->minimum, 500);
  EXPECT_FALSE(place);
}
