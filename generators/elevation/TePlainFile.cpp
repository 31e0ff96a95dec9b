#include "generators/elevation/TePlainFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

TePlainFile::TePlainFile(std::string path, int descriptor, std::uint64_t bytes)
    : m_path(std::move(path)), m_descriptor(descriptor), m_bytes(bytes) {}

TePlainFile::TePlainFile(TePlainFile&& other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)),
      m_bytes(other.m_bytes) {}

TePlainFile& TePlainFile::operator=(TePlainFile&& other) noexcept {
  std::swap(m_path, other.m_path);
  std::swap(m_descriptor, other.m_descriptor);
  std::swap(m_bytes, other.m_bytes);
  return *this;
}

TePlainFile::~TePlainFile() {
  if (m_descriptor >= 0)
    ::close(m_descriptor);
}

TeResult<TePlainFile> TePlainFile::open(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0)
    return TeError{path + ": " + std::strerror(errno)};
  struct stat status;
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    return TeError{path + ": not a plain file"};
  }
  return TePlainFile(path, descriptor, std::uint64_t(status.st_size));
}

TeStatus TePlainFile::read(std::uint64_t offset, void* data, std::size_t count) const {
  char* to = static_cast<char*>(data);
  while (count > 0) {
    const ssize_t got = ::pread(m_descriptor, to, count, off_t(offset));
    if (got < 0 && errno == EINTR)
      continue;
    if (got <= 0)
      return TeError{m_path + ": byte " + std::to_string(offset) + ": " +
                     (got < 0 ? std::strerror(errno) : "the file ends")};
    to += got;
    offset += std::uint64_t(got);
    count -= std::size_t(got);
  }
  return {};
}
