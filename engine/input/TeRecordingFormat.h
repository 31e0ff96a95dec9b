#pragma once

#include "engine/input/TeRecordedFrame.h"
#include "generators/base/TeResult.h"

#include <map>
#include <string>
#include <string_view>

/// The text of recordings, line by line:
///
///     terrane recording 1
///     setting seed 7
///     frames
///     0.0333 #00c0ffee00c0ffee +UP_ARROW +A/s -A/s
///     end 1 0123456789abcdef
///
/// Settings ascend by name. A frame is its dt (shortest decimal that reads back to the same bits), the state
/// hash if it has one, and its keys: + down or - up, name (TeKeyNames.h), modifiers after '/': s, c, a. The
/// last line has the number of frames and a hash of all bytes before that hash. Lines end with '\n'.
struct TeRecordingFormat {
  using Settings = std::map<std::string, std::string>;

  static constexpr int kVersion = 1;
  static constexpr std::size_t kMaxFrames = 4'000'000; ///< 18 hours at 60 a second
  static constexpr std::size_t kMaxKeys = 1000;        ///< of a frame
  static constexpr std::size_t kMaxBytes = 500'000'000;
  static constexpr std::string_view kMagic = "terrane recording ";
  static constexpr std::string_view kSetting = "setting ";
  static constexpr std::string_view kFrames = "frames";
  static constexpr std::string_view kEnd = "end ";

  /// Without '\n'. Names have no spaces; neither names nor values have control characters.
  static std::string settingLine(const std::string& name, const std::string& value);
  /// Why a setting cannot be written; empty if it can.
  static std::string settingFault(const std::string& name, const std::string& value);
  static std::string frameLine(const TeRecordedFrame& frame);
  /// Error: the reason alone.
  static TeResult<TeRecordedFrame> parseFrame(std::string_view line);
  static std::optional<std::uint64_t> parseHash(std::string_view text);
};
