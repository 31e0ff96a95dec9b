#include "apps/terrane-bake/TeMipmapsOptions.h"

#include "generators/base/TeHash.h"
#include "nodes/seamless/TeSeamlessLayout.h"

#include <cmath>

namespace {

std::string checkFinite(std::string& text) {
  double value = 0;
  return CLI::detail::lexical_cast(text, value) && std::isfinite(value)
             ? std::string()
             : "must be a number, not '" + text + "'";
}

} // namespace

CLI::App* TeMipmapsOptions::addTo(TeCommandLine& commandLine) {
  CLI::App* const command = commandLine.cli().add_subcommand(
      "mipmaps",
      "Makes the files OUT_0.raw, OUT_1.raw, ... of a pyramid, each of every second sample of the next");
  command->add_option("IN", input, "RAW of 16 bits, or an elevation file or picture; 2^n+1 samples a side")
      ->check(TeCommandLine::notEmpty())
      ->required();
  command->add_option("OUT", output, "What the names of the files begin with")
      ->check(TeCommandLine::notEmpty())
      ->required();
  command->add_flag("--force", force, "Replace an existing pyramid, or other unfinished work");

  const std::string reading = "Input";
  command->add_flag("--raw", raw, "IN has no header (default: if it is called .raw)")->group(reading);
  command->add_option("--raw-order", rawOrder, "Bytes of its samples: little or big (default: little)")
      ->check(CLI::IsMember({"little", "big"}))
      ->option_text("ORDER")
      ->group(reading);
  command->add_option("--raw-samples", rawSamples, "unsigned or signed (default: unsigned)")
      ->check(CLI::IsMember({"unsigned", "signed"}))
      ->option_text("KIND")
      ->group(reading);
  command->add_option("--band", band, "Heights from this band (default: 1; colours from 3 or 4 bands)")
      ->transform(TeCommandLine::wholeWithin(1, 65535))
      ->option_text("N")
      ->group(reading);
  command->add_option("--no-data", noData, "A stored value that means no data; may be given more than once")
      ->check(CLI::Validator(checkFinite, ""))
      ->option_text("VALUE")
      ->allow_extra_args(false)
      ->group(reading);
  command
      ->add_option("--fill", fill, "The stored value for samples without data (default: they are an error)")
      ->check(CLI::Validator(checkFinite, ""))
      ->option_text("VALUE")
      ->group(reading);
  command->add_flag("--resample", resample, "Interpolate any other size to the next 2^n+1")->group(reading);
  command->add_option("--posts", posts, "Metres between samples of IN (default: as it says, or 1)")
      ->check(TeCommandLine::within(1e-6, 1e6))
      ->option_text("X")
      ->group(reading);
  command
      ->add_option("--vertical-unit", verticalUnit,
                   "Of its heights: m, ft, dm, 0.1, ... (default: as it says)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("UNIT")
      ->group(reading);
  const std::string bounding = "Bounds for Seamless Patches";
  command->add_flag("!--no-bounds", bounds, "Do not measure them")->group(bounding);
  command->add_option("--min-resolution", minResolution, "Lowest resolution of a patch (default: 16)")
      ->transform(TeCommandLine::wholeWithin(2, TeSeamlessLayout::kMaxPatchResolution))
      ->option_text("N")
      ->group(bounding);
  command->add_option("--levels", levels, "Resolutions of a patch (default: 3)")
      ->transform(TeCommandLine::wholeWithin(2, TeSeamlessLayout::kMaxLevels))
      ->option_text("N")
      ->group(bounding);
  return command;
}

bool TeMipmapsOptions::isRaw() const {
  const std::string ending = input.size() < 4 ? std::string() : input.substr(input.size() - 4);
  return raw || ending == ".raw" || ending == ".RAW";
}

std::uint64_t TeMipmapsOptions::hash() const {
  std::uint64_t hash = teHashCombine(teHashText(rawOrder), teHashText(rawSamples));
  hash =
      teHashCombine(hash, std::uint64_t(isRaw()) << 32 | std::uint64_t(resample) << 16 | std::uint64_t(band));
  hash = teHashDouble(hash, fill.value_or(NAN));
  // Which heights are possible depends on their unit.
  hash = teHashCombine(hash, teHashText(verticalUnit));
  for (double value : noData)
    hash = teHashDouble(hash, value);
  return hash;
}
