#include "apps/terrane-bake/TeSynthOptions.h"

#include "nodes/clipmap/TePyramidFiles.h"

#include <charconv>

namespace {

std::string checkSide(std::string& text) {
  int side = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, side);
  if (read.ec == std::errc() && read.ptr == end && tePyramidLevelOfSide(side) > 0)
    return {};
  return "must be 2^n + 1 samples, 3 to 65537, not '" + text + "'";
}

} // namespace

CLI::App* TeSynthOptions::addTo(TeCommandLine& commandLine) {
  CLI::App* const command = commandLine.cli().add_subcommand(
      "synth", "Makes the RAW file of a large terrain: coasts and mountains, 164 km a side");
  command->add_option("OUT.raw", output, "16 bits without sign, low byte first, rows from the north")
      ->check(TeCommandLine::notEmpty())
      ->required();
  command->add_option("--size", side, "Samples a side, 2^n+1 (default: 16385)")
      ->transform(CLI::Validator(checkSide, ""))
      ->option_text("N");
  command
      ->add_option("--from", from, "The large forms from this elevation file, a square (default: of noise)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("FILE");
  command->add_flag("--force", force, "Replace an existing file");
  return command;
}
