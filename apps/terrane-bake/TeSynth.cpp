#include "apps/terrane-bake/TeSynth.h"

#include "apps/common/TeExit.h"
#include "apps/common/TeProgressLine.h"
#include "apps/common/TeStopwatch.h"
#include "apps/common/TeTerrainDescription.h"
#include "apps/terrane-bake/TeSynthTerrain.h"
#include "generators/base/TeHash.h"
#include "generators/base/TePartFile.h"
#include "generators/base/TeText.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

namespace {

bool exists(const std::string& path) {
  struct stat status;
  return ::lstat(path.c_str(), &status) == 0;
}

/// All rows; their hash.
TeResult<std::uint64_t> writeRows(TeSynthTerrain& terrain, int side, TePartFile& file, bool quiet) {
  std::vector<std::uint16_t> heights(static_cast<std::size_t>(side));
  std::vector<unsigned char> bytes(2 * heights.size());
  std::uint64_t hash = 0;
  TeProgressLine line("Making terrain", quiet);
  for (int row = 0; row < side; ++row) {
    terrain.row(row, heights.data());
    for (std::size_t i = 0; i < heights.size(); ++i) {
      bytes[2 * i] = static_cast<unsigned char>(heights[i] & 0xff);
      bytes[2 * i + 1] = static_cast<unsigned char>(heights[i] >> 8);
    }
    if (TeStatus ok = file.write(bytes.data(), bytes.size()); !ok)
      return ok.error();
    hash = teHashBytes(bytes.data(), bytes.size(), hash);
    line.update(double(row + 1) / side);
  }
  return hash;
}

} // namespace

int teBakeSynth(const std::string& application, const TeSynthOptions& options, const TeCommonOptions& common,
                TeReport& report) {
  const std::string description = TeTerrainDescription::besideRaw(options.output);
  for (const std::string& path : {options.output, description})
    if (!options.force && exists(path))
      return teExitWith(TeExitUsage, application, path + ": exists already; --force replaces it");
  const TeStopwatch time;
  TeResult<TeSynthBase> base =
      options.from.empty() ? TeSynthBase::fromNoise(common.seed) : TeSynthBase::fromFile(options.from);
  if (!base)
    return teExitWith(TeExitUsage, application, base.error().message);
  TeSynthTerrain terrain(std::move(*base), options.side, common.seed);

  TeResult<TePartFile> file = TePartFile::open(options.output);
  if (!file)
    return teExitWith(TeExitFailure, application, file.error().message);
  const TeResult<std::uint64_t> hash = writeRows(terrain, options.side, *file, common.quiet);
  TeStatus ok = hash ? TeStatus() : TeStatus(hash.error());
  if (ok) {
    ::unlink(description.c_str()); // it would speak of another file
    ok = file->finish();
  }
  if (!ok) {
    file->discard();
    return teExitWith(TeExitFailure, application, ok.error().message);
  }
  TeTerrainDescription said;
  said.samples = options.side;
  said.spacing = terrain.spacing();
  said.heightUnit = TeSynthBase::kHeightUnit;
  said.source = {{"made_by", "terrane-bake synth"}, {"seed", common.seed}, {"from", options.from}};
  if (ok = said.write(description); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);

  auto& json = report.json();
  json["samples"] = options.side;
  json["spacing_m"] = terrain.spacing();
  json["octaves"] = terrain.octaves();
  json["hash"] = teHexText(*hash);
  report.addTime("synth", time.seconds());
  if (!common.quiet)
    std::printf("%s: %dx%d samples, %g m apart, in steps of %g m\n", options.output.c_str(), options.side,
                options.side, terrain.spacing(), TeSynthBase::kHeightUnit);
  return TeExitSuccess;
}
