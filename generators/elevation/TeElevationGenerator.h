#pragma once

#include "generators/TeGenerator.h"
#include "generators/elevation/TeElevationSource.h"

#include <utility>

/// Real elevation data (TeElevationSource) with parameters that may change at any time. The file is opened,
/// and for native posts searched for its highest one, by updateParams(); it stays open, with its cache, until
/// the file or a parameter of its reading changes.
class TeElevationGenerator final : public TeGenerator {
public:
  TeElevationGenerator() { setDefaults(); }
  std::string name() const override { return "elevation"; }
  TeParameters parameters() override;

  std::string file;
  std::string encoding;   ///< auto, terrarium or raw
  std::string rawSize;    ///< COLUMNSxROWS
  std::string rawOrder;   ///< little or big
  std::string rawSamples; ///< signed or unsigned
  int band;
  std::string variable;
  std::string verticalUnit;   ///< teVerticalUnit()
  std::string horizontalUnit; ///< auto, metres, feet, us-feet or degrees
  double posts;               ///< metres; 0 = the file's
  std::string noData;         ///< numbers separated by commas or blanks
  std::string fill;           ///< none or voids
  int fillDistance;           ///< posts
  std::string outside;        ///< hole, clamp, constant or generator
  double outsideHeight;
  std::string outsideGenerator; ///< a specification
  std::string origin;           ///< centre, south-west, or LONGITUDE,LATITUDE
  bool native;

  /// The file that the present source reads; null before updateParams().
  TeElevationFilePtr elevationFile() const { return m_file; }

protected:
  void setDefaults() override;
  TeResult<TeHeightSourcePtr> makeSource() const override;

private:
  TeResult<TeElevationOptions> options() const;
  TeResult<TeElevationPlacement> placement(const TeElevationFilePtr& opened) const;
  TeStatus reopen() const;

  /// What makeSource() keeps from one call to the next, so that a change of another parameter reads nothing
  /// again.
  mutable TeElevationFilePtr m_file;
  mutable TeFileStamp m_stamp;
  mutable std::uint64_t m_optionsHash = 0;
  mutable std::pair<int, int> m_highest{-1, -1}; ///< column and row; -1 = not yet searched
};
