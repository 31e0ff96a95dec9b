#pragma once

#include "generators/TeHeightSource.h"
#include "generators/elevation/TeElevationFile.h"
#include "generators/elevation/TeElevationReader.h"

#include <vector>

/// What stands outside an elevation file.
enum class TeElevationOutside {
  Hole,     ///< missing samples
  Clamp,    ///< the height of the nearest edge
  Constant, ///< one height
  Generator ///< another source that can be evaluated at points
};

/// How an elevation file lies in the world.
struct TeElevationPlacement {
  TeElevationOutside outside = TeElevationOutside::Hole;
  float outsideHeight = 0;         ///< Constant: metres
  TeHeightSourcePtr outsideSource; ///< Generator

  /// Local position that lies at the world's origin.
  TePlanePoint origin;

  /// Samples lie on the file's posts, bit for bit; the spacing of requests must be the file's.
  bool native = false;
  /// Native: the post at the world's origin, or south-west of it where the origin lies within a cell.
  int nativeColumn = 0;
  int nativeRow = 0;
};

/// Real elevation data as a source. A sample at world position (x, y) has the file's height at local position
/// (x, y) + origin (TeElevationReader), or what stands outside. World and local metres are the same, so that
/// any spacing may be asked for; a spacing wider than the file's posts picks heights and does not average.
///
/// Maps fit without blending, and the source is evaluable at points, with the same bits. A unit of work takes
/// at most one more tile of the file; reading one takes what the file's format makes of it (a whole block of
/// it, at most 128 MB decoded, but some ten KB in the usual formats).
class TeElevationSource final : public TeHeightSource {
public:
  /// Error: an unusable placement (a source outside that is not evaluable at points, native posts of a file
  /// without one spacing).
  static TeResult<std::shared_ptr<const TeElevationSource>> create(TeElevationFilePtr file,
                                                                   const TeElevationPlacement& placement);

  std::string name() const override { return "elevation"; }
  std::uint64_t fingerprint() const override;
  bool fits() const override { return !m_placement.outsideSource || m_placement.outsideSource->fits(); }
  bool pointEvaluable() const override { return true; }
  std::unique_ptr<TeHeightJob> start(const TeMapRequest& request) const override;
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override;

  const TeElevationFilePtr& file() const { return m_file; }
  const TeElevationPlacement& placement() const { return m_placement; }

  /// Heights of the first samples, up to the one after which the reader has taken another tile; at least one.
  /// Tells how many.
  TeResult<std::size_t> evaluateSome(TeElevationReader& reader, const TeMapRequest& request,
                                     const TeMapSample* samples, std::size_t count, float* heights) const;
  /// Whether maps of this spacing can be made.
  TeStatus checkSpacing(double spacing) const;

private:
  TeElevationSource(TeElevationFilePtr file, const TeElevationPlacement& placement)
      : m_file(std::move(file)), m_placement(placement) {}

  bool toPosts(const TeMapRequest& request, TeMapSample sample, TePlanePoint& posts) const;
  bool nativePosts(const TeMapRequest& request, TeMapSample sample, TePlanePoint& posts) const;

  TeElevationFilePtr m_file;
  TeElevationPlacement m_placement;
};
