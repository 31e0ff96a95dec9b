#include "apps/terrane-view/TeViewOptions.h"

#include "apps/terrane-view/TeViewPath.h"
#include "nodes/clipmap/TeClipWindows.h"
#include "nodes/lod/TeLodMethods.h"

#include <cmath>
#include <cstdio>

namespace {

bool readPoint(const std::string& text, glm::dvec3& point) {
  int used = 0;
  return std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &point.x, &point.y, &point.z, &used) == 3 &&
         std::size_t(used) == text.size() && std::isfinite(point.x + point.y + point.z);
}

std::string checkPoint(std::string& text) {
  glm::dvec3 point;
  return readPoint(text, point) ? std::string() : "must be X,Y,Z in metres, not '" + text + "'";
}

void addPoint(TeCommandLine& commandLine, const std::string& name, std::optional<glm::dvec3>& point,
              const std::string& help) {
  commandLine.cli()
      .add_option_function<std::string>(
          name, [&point](const std::string& text) { readPoint(text, point.emplace()); }, help)
      ->check(CLI::Validator(checkPoint, ""))
      ->option_text("X,Y,Z")
      ->group("View");
}

} // namespace

void TeViewOptions::addTo(TeCommandLine& commandLine) {
  addInput(commandLine);
  addTerrain(commandLine);
  addView(commandLine);
  addFlight(commandLine);
}

void TeViewOptions::addInput(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  const std::string group = "What is shown, one of";
  cli.add_option("file", scene, "Inventor file")
      ->check(TeCommandLine::notEmpty())
      ->option_text("FILE.iv")
      ->group(group);
  CLI::Option* file = cli.add_option("--dem", dem, "Elevation file, as one terrain")
                          ->check(TeCommandLine::notEmpty())
                          ->option_text("FILE")
                          ->group(group);
  cli.add_option("--clipmaps", clipmaps, "Height pyramid NAME_0.raw, NAME_1.raw, ... of terrane-bake")
      ->check(TeCommandLine::notEmpty())
      ->option_text("NAME")
      ->group(group);

  const std::string data = "Elevation file";
  reading.addTo(cli, file, data);
  commandLine
      .addInteger("--resolution", resolution, 16, 8192,
                  "Cells a side, a power of two, to which it is resampled (default: about its own)")
      ->needs(file)
      ->group(data);
}

void TeViewOptions::addTerrain(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  const std::string group = "Terrain";
  commandLine
      .addNumber("--size-m", side, 1e-3, kMaxSize, "Metres a side (default: as the file or pyramid says)")
      ->group(group);
  commandLine
      .addNumber("--height-scale", heightScale, 1e-9, 1e6,
                 "Stretches heights; of a pyramid: metres a step (default: 1, or as the pyramid says)")
      ->group(group);
  cli.add_option("--method", method, "LOD method that draws --dem (default: Seamless Patches on the GPU)")
      ->check(CLI::IsMember(TeLodMethods::names()))
      ->option_text("NAME")
      ->needs("--dem")
      ->excludes("--clipmaps")
      ->group(group);
  commandLine
      .addInteger("--clip-size", clipSize, TeClipWindows::kMinSize, TeClipWindows::kMaxSize,
                  "Samples a side of a clip window (default: 513)")
      ->group(group);
  commandLine
      .addInteger("--patch-resolution", patchResolution, 2, 512, "Lowest resolution of a patch (default: 16)")
      ->group(group);
  commandLine.addInteger("--levels", levels, 2, 9, "Resolutions of a patch (default: 3)")->group(group);
  cli.add_option("--precision", precision, "Precision factor of the document, from 1 (default: 2)")
      ->check(TeCommandLine::within(1, 1e6))
      ->option_text("P")
      ->group(group);
  cli.add_option("--pixel-error", pixelError, "Wanted error on the screen, in place of the precision")
      ->check(TeCommandLine::within(1e-3, 1e4))
      ->option_text("PX")
      ->excludes("--precision")
      ->group(group);
  commandLine
      .addNumber(
          "--fps", fps, 1, 1000,
          "Wanted frames a second, for which the error on the screen is chosen, --pixel-error or more; "
          "not with --dt (default: none)")
      ->excludes("--precision")
      ->group(group);
  cli.add_flag("--geomorph", geomorph, "Levels change smoothly")->group(group);
  cli.add_flag("--classic", classic, "One draw call a part, no instancing")->group(group);
  cli.add_option("--coloring", colouring,
                 "plain, texture, detail or height (default: height, or texture if there is one)")
      ->check(CLI::IsMember({"plain", "texture", "detail", "height"}))
      ->option_text("HOW")
      ->group(group);
  cli.add_option("--texture", texture, "Picture over all of the terrain, north up")
      ->check(TeCommandLine::notEmpty())
      ->option_text("IMAGE")
      ->group(group);
  cli.add_option("--colors", colours, "Colour pyramid NAME_0.raw, NAME_1.raw, ... in place of the texture")
      ->check(TeCommandLine::notEmpty())
      ->option_text("NAME")
      ->excludes("--texture")
      ->group(group);
  cli.add_option("--mask", mask, "Picture of the shares of the details in red, green, blue and alpha")
      ->check(TeCommandLine::notEmpty())
      ->option_text("IMAGE")
      ->group(group);
  cli.add_option("--detail", details, "Detail picture, repeated over the terrain; give four of them")
      ->check(TeCommandLine::notEmpty())
      ->option_text("IMAGE")
      ->allow_extra_args(false)
      ->group(group);
}

void TeViewOptions::addView(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  const std::string group = "View";
  cli.add_flag("--wireframe", wireframe, "Draw lines")->group(group);
  cli.add_flag("--second-camera", secondCamera,
               "Draw from a second, higher camera what is chosen for the first")
      ->group(group);
  cli.add_flag("--statistics", statistics, "Figures over the picture")->group(group);
  cli.add_flag("--sky", sky, "A sky behind it")->group(group);
  cli.add_flag("--haze", haze, "Haze in the distance")->group(group);
  cli.add_option("--up", up, "Axis that points up: y or z (default: as the file's camera has it, or z)")
      ->check(CLI::IsMember({"y", "z"}))
      ->option_text("AXIS")
      ->group(group);
  addPoint(commandLine, "--eye", eye, "Where to begin (default: the file's camera, or all in view)");
  addPoint(commandLine, "--look", look, "Point to look at in the beginning (default: the middle)");
  cli.add_option("--screenshots", screenshots, "Folder for F12's pictures (default: the present one)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("FOLDER")
      ->group(group);
}

void TeViewOptions::addFlight(TeCommandLine& commandLine) {
  CLI::App& cli = commandLine.cli();
  const std::string group = "Flight";
  std::string names;
  for (const std::string& name : TeViewPath::names())
    names += name + ", ";
  cli.add_option("--path", path,
                 "Fly by itself: " + names + "as large as the terrain, or a file of waypoints")
      ->check(TeCommandLine::notEmpty())
      ->option_text("PATH")
      ->group(group);
  cli.add_option("--speed", speed,
                 "Metres a second on the path (default: as the file says, or the terrain's side in 60 s)")
      ->check(TeCommandLine::within(1e-6, kMaxSpeed))
      ->option_text("X")
      ->group(group);
  cli.add_option("--altitude", altitude,
                 "Metres above the ground on a built-in path (default: 2 % of the side)")
      ->check(TeCommandLine::within(0, 1e6))
      ->option_text("X")
      ->group(group);
}

TeStatus TeViewOptions::check() const {
  const int inputs = int(!scene.empty()) + int(!dem.empty()) + int(!clipmaps.empty());
  if (inputs != 1)
    return TeError{inputs == 0 ? "nothing to show: give FILE.iv, --dem FILE or --clipmaps NAME"
                               : "FILE.iv, --dem and --clipmaps exclude each other"};
  if (resolution != 0 && (resolution & (resolution - 1)) != 0)
    return TeError{"--resolution: must be a power of two, not " + std::to_string(resolution)};
  if ((patchResolution & (patchResolution - 1)) != 0)
    return TeError{"--patch-resolution: must be a power of two, not " + std::to_string(patchResolution)};
  if (!scene.empty() && (side != 0 || heightScale != 0))
    return TeError{"--size-m and --height-scale are for --dem and --clipmaps"};
  if (!method.empty() && (!texture.empty() || !colours.empty() || !mask.empty() || precision || classic))
    return TeError{"--method draws in plain colours or by height, to a --pixel-error"};
  const bool hasTexture = !texture.empty() || !colours.empty();
  const bool hasDetails = !mask.empty() && details.size() == kDetails;
  if (colouring == "texture" && !hasTexture)
    return TeError{"--coloring texture needs --texture IMAGE or --colors NAME"};
  if ((colouring == "detail" || !mask.empty() || !details.empty()) && !hasDetails)
    return TeError{"--coloring detail needs --mask IMAGE and four times --detail IMAGE"};
  if (!scene.empty() && (hasTexture || hasDetails || !colouring.empty()))
    return TeError{"--coloring and its pictures are for --dem and --clipmaps; FILE.iv has its own"};
  return {};
}
