#include "nodes/clipmap/TePyramidJournal.h"

#include "generators/base/TeText.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>
#include <utility>

namespace {

constexpr std::string_view kTitle = "terrane pyramid ";
constexpr std::size_t kMostBytes = 1 << 20; // far more than a journal ever has

template <class Number> bool readNumber(std::string_view text, Number& number, int base) {
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number, base);
  return read.ec == std::errc() && read.ptr == end;
}

TeResult<std::string> contentsOf(const std::string& path, bool& exists) {
  exists = false;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0 && errno == ENOENT)
    return std::string();
  if (descriptor < 0)
    return TeError{path + ": " + std::strerror(errno)};
  exists = true;
  std::string text;
  char buffer[4096];
  ssize_t got = 0;
  while (text.size() < kMostBytes && (got = ::read(descriptor, buffer, sizeof buffer)) > 0)
    text.append(buffer, std::size_t(got));
  const int reason = errno;
  ::close(descriptor);
  if (got < 0)
    return TeError{path + ": " + std::strerror(reason)};
  return text;
}

} // namespace

TeResult<TePyramidJournal::State> TePyramidJournal::read(const std::string& path) {
  bool exists = false;
  const TeResult<std::string> text = contentsOf(path, exists);
  if (!text)
    return text.error();
  State state;
  std::string_view left = *text;
  for (bool first = true;; first = false) {
    const std::size_t end = left.find('\n');
    if (end == std::string_view::npos) {
      // The first line may have been cut off while it was written, but is that of a journal even so.
      if (first && !left.empty() && kTitle.substr(0, left.size()) != left.substr(0, kTitle.size()))
        break;
      return state;
    }
    const std::string_view line = left.substr(0, end);
    left.remove_prefix(end + 1);
    if (first) {
      if (line.substr(0, kTitle.size()) != kTitle ||
          !readNumber(line.substr(kTitle.size()), state.fingerprint, 16))
        break;
      state.exists = true;
    } else if (!readNumber(line, state.rows, 10) || state.rows < 0) {
      break;
    }
  }
  return TeError{path + ": not the journal of a pyramid"};
}

TeResult<TePyramidJournal> TePyramidJournal::open(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, 0666);
  if (descriptor < 0)
    return TeError{path + ": cannot be written: " + std::strerror(errno)};
  TePyramidJournal journal(path, descriptor);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
    return TeError{path + ": " +
                   (errno == EWOULDBLOCK ? "another program is making this pyramid" : std::strerror(errno))};
  struct stat status;
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode) || status.st_nlink == 0)
    return TeError{path + ": no plain file, or another program has just finished this pyramid"};
  // What is appended must not follow a line that was cut off.
  bool exists = false;
  const TeResult<std::string> text = contentsOf(path, exists);
  if (!text)
    return text.error();
  const std::size_t whole = text->rfind('\n') + 1; // 0 if there is no line
  if (::ftruncate(descriptor, off_t(whole)) != 0)
    return TeError{path + ": cannot be written: " + std::strerror(errno)};
  return journal;
}

TePyramidJournal::TePyramidJournal(TePyramidJournal&& other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)) {}

TePyramidJournal& TePyramidJournal::operator=(TePyramidJournal&& other) noexcept {
  std::swap(m_path, other.m_path);
  std::swap(m_descriptor, other.m_descriptor);
  return *this;
}

TePyramidJournal::~TePyramidJournal() {
  if (m_descriptor >= 0)
    ::close(m_descriptor);
}

TeStatus TePyramidJournal::begin(std::uint64_t fingerprint) {
  if (::ftruncate(m_descriptor, 0) != 0)
    return TeError{m_path + ": cannot be written: " + std::strerror(errno)};
  return append(std::string(kTitle) + teHexText(fingerprint) + "\n");
}

TeStatus TePyramidJournal::record(int rows) { return append(std::to_string(rows) + "\n"); }

TeStatus TePyramidJournal::append(const std::string& line) {
  if (::write(m_descriptor, line.data(), line.size()) != ssize_t(line.size()) ||
      ::fdatasync(m_descriptor) != 0)
    return TeError{m_path + ": cannot be written: " + std::strerror(errno)};
  return {};
}

void TePyramidJournal::remove() {
  if (m_descriptor < 0)
    return;
  ::unlink(m_path.c_str());
  ::close(std::exchange(m_descriptor, -1));
}
