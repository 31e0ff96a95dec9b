#pragma once

#include "generators/TeHeightMap.h"
#include "generators/TeLattice.h"
#include "generators/base/TeAllowance.h"
#include "generators/base/TeResult.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

/// Which map: everything that its bits may depend on besides the source's own parameters.
struct TeMapRequest {
  int columns = 0;
  int rows = 0;
  double spacing = 1;      ///< metres between samples, in both directions
  std::int64_t firstX = 0; ///< global number of column 0
  std::int64_t firstY = 0; ///< global number of row 0
  int originHalfCells = 0; ///< the world's origin lies this many half cells from global sample 0
  std::uint64_t worldSeed = 0;
  TeMapKey key;

  /// Source map `key` (within ±TeLattice::kMaxKey) of an endless world: W×W samples.
  static TeMapRequest sourceMap(const TeLattice& lattice, std::uint64_t worldSeed, TeMapKey key);
  /// A map by itself, of any size, its south-west sample at the world's origin. Error: sides not positive, an
  /// area over TeHeightMap::kMaxSamples, a spacing that is not finite and positive.
  static TeResult<TeMapRequest> standalone(int columns, int rows, double spacing, std::uint64_t worldSeed);

  std::int64_t globalX(int column) const { return firstX + column; }
  std::int64_t globalY(int row) const { return firstY + row; }
  /// World coordinates, metres; the bits of TeLattice::position().
  double x(int column) const { return double(2 * globalX(column) - originHalfCells) * (0.5 * spacing); }
  double y(int row) const { return double(2 * globalY(row) - originHalfCells) * (0.5 * spacing); }
};

/// A sample of a map: column 0 .. columns-1, row 0 .. rows-1.
struct TeMapSample {
  int column = 0;
  int row = 0;
};

enum class TeProgress { Working, Done, Failed };

/// The making of one map, in slices. A job keeps the source that started it alive and refers to nothing
/// else, so it may run on any thread, one thread at a time.
class TeHeightJob {
public:
  virtual ~TeHeightJob();
  TeHeightJob(const TeHeightJob&) = delete;
  TeHeightJob& operator=(const TeHeightJob&) = delete;

  /// Does units of work until the allowance is spent, at least one. Any slicing gives the same bits.
  TeProgress step(TeAllowance& allowance);
  /// Does all that is left.
  TeProgress finish();

  TeProgress progress() const { return m_progress; }
  /// Why it failed, be it for want of memory; only after Failed.
  const TeError& error() const { return m_error; }
  /// Moves the finished map out; only after Done, once. columns × rows samples.
  TeHeightMap takeMap();

protected:
  TeHeightJob() = default;
  /// One smallest unit: at most about 0.25 ms at W = 65. Runs inside a TeFloatEnvironment.
  virtual TeProgress unit() = 0;
  /// To be returned by unit().
  TeProgress fail(TeError error);

  TeHeightMap m_map;

private:
  TeProgress m_progress = TeProgress::Working;
  TeError m_error;
};

/// An immutable recipe for source maps: a generator with the parameters it had when the recipe was made, or
/// a chain of a generator and filters.
///
/// *Pure*: a map is a function of the source's parameters and the request alone; the same bits whatever the
/// order of requests, the slicing, the thread, the compiler or its optimisation, and the floating-point state
/// of the caller: start() and evaluate() that compute open a TeFloatEnvironment, jobs have one. All members
/// are const and thread-safe.
class TeHeightSource : public std::enable_shared_from_this<TeHeightSource> {
public:
  virtual ~TeHeightSource();

  virtual std::string name() const = 0;
  /// Hash of the kind and of every parameter: two sources with equal fingerprints make equal maps.
  virtual std::uint64_t fingerprint() const = 0;

  /// True if a height depends on the global sample alone and not on the map that holds it: overlapping maps
  /// then agree, and patches need no blending.
  virtual bool fits() const { return false; }
  /// True if evaluate() works: heights at scattered samples cost in proportion to their number.
  virtual bool pointEvaluable() const { return false; }

  /// Whether maps of this size can be made; the error says which sizes can.
  virtual TeStatus accepts(int columns, int rows) const;
  /// Starts one map. The size must have been accepted.
  virtual std::unique_ptr<TeHeightJob> start(const TeMapRequest& request) const = 0;
  /// Whole map at once.
  TeResult<TeHeightMap> generate(const TeMapRequest& request) const;

  /// Heights of the given samples of the map, the same bits as in the map; an error if not pointEvaluable().
  /// Samples outside the map are a bug of the caller.
  virtual TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                            float* heights) const;
};

using TeHeightSourcePtr = std::shared_ptr<const TeHeightSource>;

/// A source that is defined by its values at points: derive, implement evaluate(), name() and fingerprint(),
/// and maps follow, made in runs of samples of a row.
class TePointSource : public TeHeightSource {
public:
  bool pointEvaluable() const override { return true; }
  std::unique_ptr<TeHeightJob> start(const TeMapRequest& request) const override;
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override = 0;

  /// Heights of `count` samples of one row from a column on; by default through evaluate().
  virtual TeStatus evaluateRun(const TeMapRequest& request, TeMapSample first, int count,
                               float* heights) const;

protected:
  /// Samples of a row that one unit of work evaluates.
  virtual int samplesPerUnit() const { return 256; }
};
