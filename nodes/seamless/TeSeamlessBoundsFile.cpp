#include "nodes/seamless/TeSeamlessBoundsFile.h"

#include "generators/base/TeHash.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace {

using Measured = TeSeamlessBounds::Measured;

/// "TeSB" "nds1"
constexpr std::array<std::uint32_t, 2> kMagic = {0x42536554, 0x3173646E};
constexpr std::size_t kWordBytes = 4;
constexpr std::size_t kHashBytes = 8;
constexpr std::size_t kPieceBytes = 64 * 1024;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FilePtr = std::unique_ptr<std::FILE, CloseFile>;

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
  explicit WordWriter(std::FILE* file) : m_file(file) {}

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
  bool finish() {
    flush();
    putBytes(m_piece, m_hash);
    flush();
    return m_good && std::fflush(m_file) == 0;
  }

private:
  void flush() {
    m_hash = teHashBytes(m_piece.data(), m_piece.size(), m_hash);
    m_good = m_good && std::fwrite(m_piece.data(), 1, m_piece.size(), m_file) == m_piece.size();
    m_piece.clear();
  }

  std::FILE* m_file;
  std::vector<unsigned char> m_piece;
  std::uint64_t m_hash = 0;
  bool m_good = true;
};

class WordReader {
public:
  /// `bytes`: of all words.
  WordReader(std::FILE* file, std::uintmax_t bytes) : m_file(file), m_left(bytes) {}

  /// What fails is told by finish().
  std::uint32_t read() {
    if (m_good && m_position == m_piece.size())
      fill();
    if (m_position + kWordBytes > m_piece.size())
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
  bool finish() {
    std::array<unsigned char, kHashBytes> hash{};
    return m_good && m_left == 0 && m_position == m_piece.size() &&
           std::fread(hash.data(), 1, hash.size(), m_file) == hash.size() &&
           numberAt<std::uint64_t>(hash.data()) == m_hash;
  }

private:
  void fill() {
    m_piece.resize(std::size_t(std::min<std::uintmax_t>(m_left, kPieceBytes)));
    m_position = 0;
    m_left -= m_piece.size();
    m_good =
        m_good && !m_piece.empty() && std::fread(m_piece.data(), 1, m_piece.size(), m_file) == m_piece.size();
    m_hash = teHashBytes(m_piece.data(), m_piece.size(), m_hash);
  }

  std::FILE* m_file;
  std::uintmax_t m_left;
  std::vector<unsigned char> m_piece;
  std::size_t m_position = 0;
  std::uint64_t m_hash = 0;
  bool m_good = true;
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
std::uintmax_t bytesOf(const TeSeamlessLayout& layout) {
  std::uintmax_t words = kMagic.size() + sizesOf(layout).size() + 2 * patchesOfDeepest(layout);
  for (int level = 0; level < layout.depth(); level++)
    words += errorsOf(layout, level);
  return words * kWordBytes;
}

TeResult<Measured> readMeasured(const TeSeamlessLayout& layout, std::FILE* stream, std::uintmax_t size) {
  WordReader reader(stream, bytesOf(layout));
  std::array<std::uint32_t, 2> magic{};
  std::array<std::uint32_t, 3> sizes{};
  const std::uintmax_t headerBytes = (magic.size() + sizes.size()) * kWordBytes;
  for (std::uint32_t& word : magic)
    word = reader.read();
  if (size < headerBytes || magic != kMagic)
    return TeError{"no bounds of seamless patches, or of another version"};
  for (std::uint32_t& word : sizes)
    word = reader.read();
  if (sizes != sizesOf(layout))
    return TeError{"measured for resolution " + std::to_string(sizes[0]) + ", minimum patch resolution " +
                   std::to_string(sizes[1]) + " and " + std::to_string(sizes[2]) +
                   " levels, or damaged; wanted are " + std::to_string(layout.resolution()) + ", " +
                   std::to_string(layout.minResolution()) + " and " + std::to_string(layout.levels())};
  if (const std::uintmax_t wanted = bytesOf(layout) + kHashBytes; size != wanted)
    return TeError{std::string(size < wanted ? "cut off" : "too long") + ": " + std::to_string(size) +
                   " bytes in place of " + std::to_string(wanted)};

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
  if (!reader.finish())
    return TeError{"damaged: its checksum is another"};
  return measured;
}

TeError notWritten(const std::string& file, int reason) {
  return {file + ": cannot be written: " + std::strerror(reason)};
}

} // namespace

std::string TeSeamlessBoundsFile::nameFor(const std::string& pyramid, const TeSeamlessLayout& layout) {
  return pyramid + "_bounds_" + std::to_string(layout.minResolution()) + "_" +
         std::to_string(layout.levels()) + ".bin";
}

TeStatus TeSeamlessBoundsFile::save(const TeSeamlessBounds& bounds, const std::string& file) {
  std::error_code unknown;
  if (const fs::file_status status = fs::status(file, unknown);
      fs::exists(status) && !fs::is_regular_file(status))
    return TeError{file + ": cannot be written: it is not a plain file"};
  const std::string part = file + ".part";
  errno = 0;
  FilePtr stream(std::fopen(part.c_str(), "wb"));
  if (!stream)
    return notWritten(file, errno);
  WordWriter writer(stream.get());
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
  bool good = writer.finish();
  good = std::fclose(stream.release()) == 0 && good;
  if (good && std::rename(part.c_str(), file.c_str()) == 0)
    return {};
  const int reason = errno;
  std::remove(part.c_str());
  return notWritten(file, reason);
}

TeResult<std::shared_ptr<const TeSeamlessBounds>> TeSeamlessBoundsFile::load(const TeSeamlessLayout& layout,
                                                                             const std::string& file) {
  if (layout.patchCount() > TeSeamlessBounds::kMaxPatches)
    return TeError{file + ": cannot be read: the layout has too many patches"};
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error)
    return TeError{file + ": cannot be read: " + error.message()};
  const FilePtr stream(std::fopen(file.c_str(), "rb"));
  if (!stream)
    return TeError{file + ": cannot be read: " + std::strerror(errno)};
  try {
    TeResult<Measured> measured = readMeasured(layout, stream.get(), size);
    if (!measured)
      return TeError{file + ": " + measured.error().message};
    TeResult<std::shared_ptr<const TeSeamlessBounds>> bounds =
        TeSeamlessBounds::create(layout, std::move(*measured));
    if (!bounds)
      return TeError{file + ": " + bounds.error().message};
    return bounds;
  } catch (const std::bad_alloc&) {
    return TeError{file + ": not enough memory"};
  }
}
