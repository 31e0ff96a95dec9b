#pragma once

#include "apps/terrane-bake/TeHeightCode.h"
#include "apps/terrane-bake/TeMipmapsOptions.h"
#include "apps/terrane-bake/TeRows.h"
#include "generators/elevation/TeElevationOptions.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

/// The input of a pyramid as samples of its highest level.
class TeBakeSource {
public:
  /// Error: missing, damaged, of a size that is not 2^n + 1 (without resampling), or of no known kind.
  static TeResult<TeBakeSource> open(const TeMipmapsOptions& options);

  int level() const { return m_level; }
  bool isColour() const { return m_channels > 1; }
  int sampleBytes() const { return isColour() ? m_channels : 2; }
  /// Of the input's state and all options that samples depend on.
  std::uint64_t fingerprint() const { return m_fingerprint; }

  /// Chooses how heights become 16 bits; before the first row. Error: samples are missing, or unreadable.
  TeStatus measure(const std::function<void(double)>& progress);
  /// A row from the north: side · sampleBytes() bytes. Error: unreadable; a colour that is no byte.
  TeStatus read(int row, unsigned char* samples);

  /// Gives back the memory that reading took; no rows can be read after that.
  void close();

  /// Metres between samples.
  double spacing() const { return m_spacing; }
  /// Metres of height: offset + unit · sample.
  double heightUnit() const { return m_code.step * m_unit; }
  double heightOffset() const { return m_offset + m_code.offset * m_unit; }

private:
  TeBakeSource() = default;
  TeStatus openRows(const TeMipmapsOptions& options, const TeElevationOptions& reading);
  TeStatus fit(const TeMipmapsOptions& options);

  std::string m_path;
  std::unique_ptr<TeRows> m_rows;
  TeRows* m_stored = nullptr; ///< what m_rows are made of, or they themselves
  std::optional<double> m_fill;
  int m_channels = 1;
  bool m_codeIsKnown = false;
  int m_level = 0;
  std::uint64_t m_fingerprint = 0;
  TeHeightCode m_code;
  double m_spacing = 1;
  double m_unit = 1; ///< metres of a stored number
  double m_offset = 0;
  std::vector<double> m_numbers; ///< a row
};
