#include "apps/terrane-bake/TeMipmaps.h"

#include "apps/common/TeExit.h"
#include "apps/common/TeProgressLine.h"
#include "apps/common/TeStopwatch.h"
#include "apps/common/TeTerrainDescription.h"
#include "apps/terrane-bake/TeBakeSource.h"
#include "apps/terrane-bake/TePyramidBounds.h"
#include "nodes/clipmap/TePyramidWriter.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

namespace {

/// How work ends, and why if it did not succeed.
struct Outcome {
  TeExit status = TeExitSuccess;
  std::string reason;
};

bool exists(const std::string& path) {
  struct stat status;
  return ::lstat(path.c_str(), &status) == 0;
}

Outcome badInput(const TeError& error) { return {TeExitUsage, error.message}; }
Outcome failed(const TeError& error) { return {TeExitFailure, error.message}; }

class Mipmaps {
public:
  Mipmaps(const TeMipmapsOptions& options, bool quiet, TeReport& report)
      : m_options(options), m_quiet(quiet), m_report(report) {}

  Outcome run() {
    TeResult<TeBakeSource> source = TeBakeSource::open(m_options);
    if (!source)
      return badInput(source.error());
    if (TeStatus ok = chooseBounds(*source); !ok)
      return badInput(ok.error());
    const TePyramidPlan plan{m_options.output, source->level(), source->sampleBytes(), source->fingerprint()};
    if (TeStatus ok = keepsInput(); !ok)
      return badInput(ok.error());
    if (TeStatus ok = mayWrite(plan); !ok)
      return badInput({ok.error().message + "; --force replaces what is there"});
    if (Outcome end = measure(*source); end.status != TeExitSuccess)
      return end;
    TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan);
    if (!writer)
      return failed(writer.error());
    if (Outcome end = writeLevels(*source, *writer); end.status != TeExitSuccess)
      return end;
    source->close();
    if (Outcome end = complete(*source, *writer); end.status != TeExitSuccess)
      return end;
    writer->forget();
    return {};
  }

private:
  /// Bounds are of heights, and of terrains that are not smaller than a patch.
  TeStatus chooseBounds(const TeBakeSource& source) {
    const int resolution = tePyramidSide(source.level()) - 1;
    if (!m_options.bounds || source.isColour() || resolution < m_options.minResolution)
      return {};
    const TeResult<TeSeamlessLayout> layout =
        TeSeamlessLayout::create(resolution, m_options.minResolution, m_options.levels);
    if (!layout)
      return layout.error();
    m_layout = *layout;
    return {};
  }

  /// What is read must not be among the files that are written or removed.
  TeStatus keepsInput() const {
    std::vector<std::string> files = tePyramidBoundsBeside(m_options.output);
    for (int level = 0; level <= kTeHighestPyramidLevel; ++level)
      files.push_back(tePyramidLevelFile(m_options.output, level));
    for (const std::string& file : files)
      for (const std::string& touched : {file, TePartFile::partOf(file)}) {
        std::error_code ignored;
        if (std::filesystem::equivalent(m_options.input, touched, ignored))
          return TeError{m_options.input + ": would be replaced, as one of the files of " + m_options.output};
      }
    return {};
  }

  TeStatus mayWrite(const TePyramidPlan& plan) const {
    if (m_options.force)
      return {};
    if (TeStatus ok = TePyramidWriter::check(plan); !ok)
      return ok;
    if (exists(TePyramidWriter::journalOf(plan)))
      return {};
    std::vector<std::string> files = tePyramidBoundsBeside(plan.name);
    files.push_back(TeTerrainDescription::besidePyramid(plan.name));
    for (const std::string& file : files)
      if (exists(file))
        return TeError{file + ": exists already"};
    return {};
  }

  Outcome measure(TeBakeSource& source) {
    const TeStopwatch time;
    TeProgressLine line("Looking at heights", m_quiet);
    if (TeStatus ok = source.measure([&](double done) { line.update(done); }); !ok)
      return badInput(ok.error());
    m_report.addTime("measure", time.seconds());
    return {};
  }

  Outcome writeLevels(TeBakeSource& source, TePyramidWriter& writer) {
    const TeStopwatch time;
    const int side = tePyramidSide(source.level());
    m_report.json()["resumed_from_row"] = writer.nextRow();
    std::vector<unsigned char> row(std::size_t(side) * std::size_t(source.sampleBytes()));
    TeProgressLine line("Writing levels", m_quiet);
    while (writer.nextRow() < side) {
      if (TeStatus ok = source.read(writer.nextRow(), row.data()); !ok) {
        writer.discard(); // nothing to go on with
        return badInput(ok.error());
      }
      if (TeStatus ok = writer.write(row.data()); !ok)
        return failed(ok.error());
      line.update(double(writer.nextRow()) / side);
    }
    m_report.addTime("levels", time.seconds());
    return {};
  }

  /// Levels take their names; what speaks of them follows, and what spoke of others goes before.
  Outcome complete(const TeBakeSource& source, TePyramidWriter& writer) {
    const std::string description = TeTerrainDescription::besidePyramid(m_options.output);
    ::unlink(description.c_str());
    for (const std::string& bounds : tePyramidBoundsBeside(m_options.output))
      ::unlink(bounds.c_str());
    if (TeStatus ok = writer.finish(); !ok)
      return failed(ok.error());
    if (TeStatus ok = describe(source).write(description); !ok)
      return failed(ok.error());
    if (!m_layout)
      return {};
    const TeStopwatch time;
    TeProgressLine line("Measuring bounds", m_quiet);
    const TeResult<std::string> bounds =
        teWritePyramidBounds(m_options.output, *m_layout, [&](double done) { line.update(done); });
    if (!bounds)
      return failed(bounds.error());
    m_report.json()["bounds"] = *bounds;
    m_report.addTime("bounds", time.seconds());
    return {};
  }

  TeTerrainDescription describe(const TeBakeSource& source) const {
    TeTerrainDescription description;
    description.samples = tePyramidSide(source.level());
    description.sampleBytes = source.sampleBytes();
    description.spacing = source.spacing();
    description.heightUnit = source.heightUnit();
    description.heightOffset = source.heightOffset();
    description.colour = source.isColour();
    description.levels = source.level() + 1;
    description.source = m_options.input;
    auto& json = m_report.json();
    json["levels"] = description.levels;
    json["samples"] = description.samples;
    json["sample_bytes"] = description.sampleBytes;
    json["spacing_m"] = description.spacing;
    json["height_unit_m"] = description.heightUnit;
    json["height_offset_m"] = description.heightOffset;
    return description;
  }

  const TeMipmapsOptions& m_options;
  bool m_quiet;
  TeReport& m_report;
  std::optional<TeSeamlessLayout> m_layout; ///< of the bounds, if there shall be any
};

} // namespace

int teBakeMipmaps(const std::string& application, const TeMipmapsOptions& options,
                  const TeCommonOptions& common, TeReport& report) {
  const Outcome end = Mipmaps(options, common.quiet, report).run();
  if (end.status != TeExitSuccess)
    return teExitWith(end.status, application, end.reason);
  if (!common.quiet)
    std::printf("%s: levels 0 to %d\n", options.output.c_str(), int(report.json()["levels"]) - 1);
  return TeExitSuccess;
}
