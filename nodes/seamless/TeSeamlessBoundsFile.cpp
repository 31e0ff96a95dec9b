#include "nodes/seamless/TeSeamlessBoundsFile.h"

#include "generators/base/TeHash.h"
#include "generators/base/TePartFile.h"
#include "generators/elevation/TePlainFile.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <new>
#include <utility>

namespace {

using Measured = TeSeamlessBounds::Measured;

/// "TeSB" "nds1"
constexpr std::array<std::uint32_t, 2> kMagic = {0x42536554, 0x3173646E};
constexpr std::size_t kWordBytes = 4;
constexpr std::size_t kHashBytes = 8;
constexpr std::size_t kPieceBytes = 64 * 1024;

template <class Number> void putBytes(std::vector<unsigned char>& bytes, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); i++)
    bytes.push_back(static_cast<unsigned char>(number >> (8 * i)));
}

template <class Number> Number numberAt(const unsigned char* bytes) {
  Number number = 0;
  for (std::size_t i = 0; i < sizeof(Number); i++)
    number |= Number(bytes[i]) << (8 * i);
  return number;
}

class WordWriter {
public:
  explicit WordWriter(TePartFile& file) : m_file(file) {}

  /// What fails is told by finish().
  void write(std::uint32_t word) {
    putBytes(m_piece, word);
    if (m_piece.size() == kPieceBytes)
      flush();
  }
  void write(float number) {
    std::uint32_t word;
    static_assert(sizeof word == sizeof number);
    std::memcpy(&word, &number, sizeof word);
    write(word);
  }
  TeStatus finish() {
    flush();
    putBytes(m_piece, m_hash);
    flush();
    return m_status ? m_file.finish() : m_status;
  }

private:
  void flush() {
    m_hash = teHashBytes(m_piece.data(), m_piece.size(), m_hash);
    if (m_status)
      m_status = m_file.write(m_piece.data(), m_piece.size());
    m_piece.clear();
  }

  TePartFile& m_file;
  std::vector<unsigned char> m_piece;
  std::uint64_t m_hash = 0;
  TeStatus m_status;
};

class WordReader {
public:
  /// `bytes`: of all words.
  WordReader(const TePlainFile& file, std::uint64_t bytes) : m_file(file), m_bytes(bytes) {}

  /// 0 if it cannot be read, which finish() tells.
  std::uint32_t read() {
    if (m_status && m_position == m_piece.size())
      fill();
    if (!m_status)
      return 0;
    m_position += kWordBytes;
    return numberAt<std::uint32_t>(m_piece.data() + m_position - kWordBytes);
  }
  float readFloat() {
    const std::uint32_t word = read();
    float number;
    std::memcpy(&number, &word, sizeof number);
    return number;
  }
  /// After the last word: whether all of them were read and are those that were written.
  TeStatus finish(const std::string& name) {
    std::array<unsigned char, kHashBytes> hash{};
    if (m_status)
      m_status = m_file.read(m_bytes, hash.data(), hash.size());
    if (m_status && numberAt<std::uint64_t>(hash.data()) != m_hash)
      m_status = TeError{name + ": damaged: its checksum is another"};
    return m_status;
  }

private:
  void fill() {
    m_piece.resize(std::size_t(std::min<std::uint64_t>(m_bytes - m_offset, kPieceBytes)));
    m_status = m_file.read(m_offset, m_piece.data(), m_piece.size());
    m_hash = teHashBytes(m_piece.data(), m_piece.size(), m_hash);
    m_offset += m_piece.size();
    m_position = 0;
  }

  const TePlainFile& m_file;
  std::uint64_t m_bytes;
  std::uint64_t m_offset = 0; ///< of what follows m_piece
  std::vector<unsigned char> m_piece;
  std::size_t m_position = 0; ///< in m_piece
  std::uint64_t m_hash = 0;
  TeStatus m_status;
};

std::array<std::uint32_t, 3> sizesOf(const TeSeamlessLayout& layout) {
  return {std::uint32_t(layout.resolution()), std::uint32_t(layout.minResolution()),
          std::uint32_t(layout.levels())};
}

std::size_t patchesOfDeepest(const TeSeamlessLayout& layout) {
  const std::size_t side = std::size_t(layout.patchesPerSide(layout.depth() - 1));
  return side * side;
}

std::size_t errorsOf(const TeSeamlessLayout& layout, int level) {
  return std::size_t(layout.sideCount(level)) * std::size_t(layout.levels());
}

/// Of all words of a file.
std::uint64_t bytesOf(const TeSeamlessLayout& layout) {
  std::uint64_t words = kMagic.size() + sizesOf(layout).size() + 2 * patchesOfDeepest(layout);
  for (int level = 0; level < layout.depth(); level++)
    words += errorsOf(layout, level);
  return words * kWordBytes;
}

TeStatus checkHeader(const TeSeamlessLayout& layout, const TePlainFile& file, const std::string& name) {
  std::array<std::uint32_t, 2> magic{};
  std::array<std::uint32_t, 3> sizes{};
  const std::uint64_t headerBytes = (magic.size() + sizes.size()) * kWordBytes;
  WordReader header(file, headerBytes);
  if (file.bytes() >= headerBytes) {
    for (std::uint32_t& word : magic)
      word = header.read();
    for (std::uint32_t& word : sizes)
      word = header.read();
  }
  if (magic != kMagic)
    return TeError{name + ": no bounds of seamless patches, or of another version"};
  if (sizes != sizesOf(layout))
    return TeError{name + ": measured for resolution " + std::to_string(sizes[0]) +
                   ", minimum patch resolution " + std::to_string(sizes[1]) + " and " +
                   std::to_string(sizes[2]) + " levels, or damaged; wanted are " +
                   std::to_string(layout.resolution()) + ", " + std::to_string(layout.minResolution()) +
                   " and " + std::to_string(layout.levels())};
  if (const std::uint64_t wanted = bytesOf(layout) + kHashBytes; file.bytes() != wanted)
    return TeError{name + (file.bytes() < wanted ? ": cut off: " : ": too long: ") +
                   std::to_string(file.bytes()) + " bytes in place of " + std::to_string(wanted)};
  return {};
}

TeResult<Measured> readMeasured(const TeSeamlessLayout& layout, const TePlainFile& file,
                                const std::string& name) {
  WordReader reader(file, bytesOf(layout));
  for (std::size_t i = 0; i < kMagic.size() + sizesOf(layout).size(); i++)
    reader.read();
  Measured measured;
  for (int level = 0; level < layout.depth(); level++) {
    measured.errors.emplace_back(errorsOf(layout, level));
    for (float& error : measured.errors.back())
      error = reader.readFloat();
  }
  measured.ranges.resize(patchesOfDeepest(layout));
  for (TeHeightRange& range : measured.ranges) {
    range.low = reader.readFloat();
    range.high = reader.readFloat();
  }
  if (TeStatus status = reader.finish(name); !status)
    return status.error();
  return measured;
}

} // namespace

std::string TeSeamlessBoundsFile::nameFor(const std::string& pyramid, const TeSeamlessLayout& layout) {
  return pyramid + "_bounds_" + std::to_string(layout.minResolution()) + "_" +
         std::to_string(layout.levels()) + ".bin";
}

TeStatus TeSeamlessBoundsFile::save(const TeSeamlessBounds& bounds, const std::string& file) {
  TeResult<TePartFile> part = TePartFile::open(file);
  if (!part)
    return part.error();
  WordWriter writer(*part);
  for (const std::uint32_t word : kMagic)
    writer.write(word);
  for (const std::uint32_t word : sizesOf(bounds.layout()))
    writer.write(word);
  for (const std::vector<float>& errors : bounds.measured().errors)
    for (const float error : errors)
      writer.write(error);
  for (const TeHeightRange& range : bounds.measured().ranges) {
    writer.write(range.low);
    writer.write(range.high);
  }
  const TeStatus status = writer.finish();
  if (!status)
    part->discard();
  return status;
}

TeResult<std::shared_ptr<const TeSeamlessBounds>> TeSeamlessBoundsFile::load(const TeSeamlessLayout& layout,
                                                                             const std::string& file) {
  if (layout.patchCount() > TeSeamlessBounds::kMaxPatches)
    return TeError{file + ": cannot be read: the layout has too many patches"};
  const TeResult<TePlainFile> plain = TePlainFile::open(file);
  if (!plain)
    return plain.error();
  try {
    if (TeStatus status = checkHeader(layout, *plain, file); !status)
      return status.error();
    TeResult<Measured> measured = readMeasured(layout, *plain, file);
    if (!measured)
      return measured.error();
    TeResult<std::shared_ptr<const TeSeamlessBounds>> bounds =
        TeSeamlessBounds::create(layout, std::move(*measured));
    if (!bounds)
      return TeError{file + ": " + bounds.error().message};
    return bounds;
  } catch (const std::bad_alloc&) {
    return TeError{file + ": not enough memory"};
  }
}
