#include "generators/elevation/TeElevationSource.h"

#include "generators/base/TeFloatEnvironment.h"
#include "generators/base/TeHash.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace {

constexpr int kSamplesPerUnit = 256;

/// One map, row by row; a unit ends when a tile had to be taken.
class ElevationJob final : public TeHeightJob {
public:
  ElevationJob(std::shared_ptr<const TeElevationSource> source, const TeMapRequest& request)
      : m_source(std::move(source)), m_reader(m_source->file()), m_request(request) {}

protected:
  TeProgress unit() override {
    if (m_map.empty()) {
      if (TeStatus ok = m_source->checkSpacing(m_request.spacing); !ok)
        return fail(ok.error());
      TeResult<TeHeightMap> map = TeHeightMap::create(m_request.columns, m_request.rows);
      if (!map)
        return fail(map.error());
      m_map = std::move(*map);
    }
    TeMapSample samples[kSamplesPerUnit];
    const int count = std::min(kSamplesPerUnit, m_request.columns - m_next.column);
    for (int i = 0; i < count; ++i)
      samples[i] = {m_next.column + i, m_next.row};
    const TeResult<std::size_t> done = m_source->evaluateSome(
        m_reader, m_request, samples, std::size_t(count), m_map.row(m_next.row) + m_next.column);
    if (!done)
      return fail(done.error());
    m_next.column += int(*done);
    if (m_next.column == m_request.columns)
      m_next = {0, m_next.row + 1};
    return m_next.row == m_request.rows ? TeProgress::Done : TeProgress::Working;
  }

private:
  std::shared_ptr<const TeElevationSource> m_source;
  TeElevationReader m_reader;
  TeMapRequest m_request;
  TeMapSample m_next;
};

} // namespace

TeResult<std::shared_ptr<const TeElevationSource>>
TeElevationSource::create(TeElevationFilePtr file, const TeElevationPlacement& placement) {
  if (!file)
    return TeError{"elevation: no file"};
  if (placement.outside == TeElevationOutside::Generator &&
      (!placement.outsideSource || !placement.outsideSource->pointEvaluable()))
    return TeError{"elevation: the generator outside the file must be one that can be evaluated at points"};
  if (!std::isfinite(placement.outsideHeight) || !std::isfinite(placement.origin.x) ||
      !std::isfinite(placement.origin.y))
    return TeError{"elevation: the height outside and the origin must be finite"};
  if (placement.native) {
    if (const TeResult<double> spacing = file->nativeSpacing(); !spacing)
      return spacing.error();
    if (placement.nativeColumn < 0 || placement.nativeColumn >= file->columns() || placement.nativeRow < 0 ||
        placement.nativeRow >= file->rows())
      return TeError{file->path() + ": there is no post (" + std::to_string(placement.nativeColumn) + ", " +
                     std::to_string(placement.nativeRow) + ")"};
  }
  std::shared_ptr<TeElevationSource> source(new TeElevationSource(std::move(file), placement));
  if (placement.outside != TeElevationOutside::Generator)
    source->m_placement.outsideSource.reset();
  return std::shared_ptr<const TeElevationSource>(std::move(source));
}

std::uint64_t TeElevationSource::fingerprint() const {
  std::uint64_t hash = teHashCombine(teHashText(name()), m_file->fingerprint());
  for (int value :
       {int(m_placement.outside), int(m_placement.native), m_placement.nativeColumn, m_placement.nativeRow})
    hash = teHashCombine(hash, std::uint64_t(value));
  for (double value : {double(m_placement.outsideHeight), m_placement.origin.x, m_placement.origin.y})
    hash = teHashDouble(hash, value);
  return m_placement.outsideSource ? teHashCombine(hash, m_placement.outsideSource->fingerprint()) : hash;
}

TeStatus TeElevationSource::checkSpacing(double spacing) const {
  if (!m_placement.native)
    return {};
  const double native = m_file->postSpacing().x;
  if (std::fabs(spacing - native) <= 1e-9 * native)
    return {};
  return TeError{m_file->path() + ": native posts lie " + std::to_string(native) +
                 " m apart, but a spacing of " + std::to_string(spacing) + " m is asked for"};
}

std::unique_ptr<TeHeightJob> TeElevationSource::start(const TeMapRequest& request) const {
  auto self = std::static_pointer_cast<const TeElevationSource>(shared_from_this());
  return std::make_unique<ElevationJob>(std::move(self), request);
}

TeStatus TeElevationSource::evaluate(const TeMapRequest& request, const TeMapSample* samples,
                                     std::size_t count, float* heights) const {
  if (TeStatus ok = checkSpacing(request.spacing); !ok)
    return ok;
  const TeFloatEnvironment environment;
  TeElevationReader reader(m_file);
  for (std::size_t first = 0; first < count;) {
    const TeResult<std::size_t> done =
        evaluateSome(reader, request, samples + first, count - first, heights + first);
    if (!done)
      return done.error();
    first += *done;
  }
  return {};
}

TeResult<std::size_t> TeElevationSource::evaluateSome(TeElevationReader& reader, const TeMapRequest& request,
                                                      const TeMapSample* samples, std::size_t count,
                                                      float* heights) const {
  const std::int64_t tilesBefore = reader.tilesTaken();
  std::vector<TeMapSample> outside;
  std::vector<std::size_t> outsideIndex;
  std::size_t done = 0;
  while (done < count && (done == 0 || reader.tilesTaken() == tilesBefore)) {
    const std::size_t i = done++;
    TePlanePoint posts;
    const bool somewhere =
        m_placement.native ? nativePosts(request, samples[i], posts) : toPosts(request, samples[i], posts);
    const bool inside = somewhere && m_file->contains(posts);
    if (inside || (somewhere && m_placement.outside == TeElevationOutside::Clamp)) {
      if (TeStatus ok = reader.height(posts, heights[i]); !ok)
        return ok.error();
    } else if (m_placement.outside == TeElevationOutside::Constant) {
      heights[i] = m_placement.outsideHeight;
    } else if (m_placement.outsideSource) {
      outside.push_back(samples[i]);
      outsideIndex.push_back(i);
    } else {
      heights[i] = TeHeightMap::missing();
    }
  }
  if (outside.empty())
    return done;
  std::vector<float> outsideHeights(outside.size());
  if (TeStatus ok =
          m_placement.outsideSource->evaluate(request, outside.data(), outside.size(), outsideHeights.data());
      !ok)
    return ok.error();
  for (std::size_t k = 0; k < outside.size(); ++k)
    heights[outsideIndex[k]] = outsideHeights[k];
  return done;
}

bool TeElevationSource::toPosts(const TeMapRequest& request, TeMapSample sample, TePlanePoint& posts) const {
  TePlanePoint local{request.x(sample.column) + m_placement.origin.x,
                     request.y(sample.row) + m_placement.origin.y};
  // Far outside the tangent plane has no point of the Earth; the edge of the terrain is to go on there too.
  if (m_placement.outside == TeElevationOutside::Clamp && std::isfinite(local.x) && std::isfinite(local.y)) {
    const TeLocalExtent& extent = m_file->extent();
    local = {std::clamp(local.x, extent.west, extent.east), std::clamp(local.y, extent.south, extent.north)};
  }
  return m_file->toPosts(local, posts);
}

bool TeElevationSource::nativePosts(const TeMapRequest& request, TeMapSample sample,
                                    TePlanePoint& posts) const {
  const std::int64_t half = request.originHalfCells / 2;
  const std::int64_t east = request.globalX(sample.column) - half;
  const std::int64_t north = request.globalY(sample.row) - half;
  posts = {double(m_placement.nativeColumn) + double(m_file->columnsRunEast() ? east : -east),
           double(m_placement.nativeRow) + double(m_file->rowsRunNorth() ? north : -north)};
  return true;
}
