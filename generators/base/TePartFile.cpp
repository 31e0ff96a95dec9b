#include "generators/base/TePartFile.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

TePartFile::TePartFile(TePartFile&& other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)),
      m_written(other.m_written), m_changed(other.m_changed), m_buffer(std::move(other.m_buffer)) {}

TePartFile& TePartFile::operator=(TePartFile&& other) noexcept {
  std::swap(m_path, other.m_path);
  std::swap(m_descriptor, other.m_descriptor);
  std::swap(m_written, other.m_written);
  std::swap(m_changed, other.m_changed);
  std::swap(m_buffer, other.m_buffer);
  return *this;
}

TePartFile::~TePartFile() {
  if (m_descriptor >= 0)
    ::close(m_descriptor);
}

TeError TePartFile::failure(const std::string& path) const {
  return TeError{path + ": cannot be written: " + std::strerror(errno)};
}

TeResult<TePartFile> TePartFile::open(const std::string& path, std::uint64_t keep) {
  const std::string part = partOf(path);
  const int descriptor = ::open(part.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK, 0666);
  TePartFile file(path, descriptor, keep);
  if (descriptor < 0 && errno == ELOOP)
    return TeError{part + ": a link, not a plain file"};
  if (descriptor < 0)
    return file.failure(path);
  struct stat status;
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
    return TeError{part + ": not a plain file"};
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return TeError{part + ": another program is writing it"};
  // Between opening and locking the other one may have finished: what is open here has its name already.
  struct stat named;
  if (::stat(part.c_str(), &named) != 0 || named.st_dev != status.st_dev || named.st_ino != status.st_ino)
    return TeError{part + ": another program has just finished it"};
  if (std::uint64_t(status.st_size) < keep)
    return TeError{part + ": " + std::to_string(status.st_size) + " bytes, but " + std::to_string(keep) +
                   " were written"};
  if (::ftruncate(descriptor, off_t(keep)) != 0)
    return file.failure(part);
  file.m_buffer.reserve(kBufferBytes);
  return file;
}

TeStatus TePartFile::writeWhole(const std::string& path, const std::string& contents) {
  TeResult<TePartFile> file = open(path);
  if (!file)
    return file.error();
  TeStatus ok = file->write(contents.data(), contents.size());
  if (ok)
    ok = file->finish();
  if (!ok)
    file->discard();
  return ok;
}

TeStatus TePartFile::write(const void* data, std::size_t count) {
  m_changed = true;
  const char* from = static_cast<const char*>(data);
  while (count > 0) {
    const std::size_t fits = std::min(count, kBufferBytes - m_buffer.size());
    m_buffer.insert(m_buffer.end(), from, from + fits);
    from += fits;
    count -= fits;
    if (m_buffer.size() == kBufferBytes)
      if (TeStatus ok = writeBuffer(); !ok)
        return ok;
  }
  return {};
}

TeStatus TePartFile::writeBuffer() {
  std::size_t done = 0;
  while (done < m_buffer.size()) {
    const ssize_t got =
        ::pwrite(m_descriptor, m_buffer.data() + done, m_buffer.size() - done, off_t(m_written));
    if (got < 0 && errno == EINTR)
      continue;
    if (got <= 0)
      return failure(partOf(m_path));
    done += std::size_t(got);
    m_written += std::uint64_t(got);
  }
  m_buffer.clear();
  return {};
}

TeStatus TePartFile::flush() {
  if (!m_changed)
    return {};
  if (TeStatus ok = writeBuffer(); !ok)
    return ok;
  if (::fdatasync(m_descriptor) != 0)
    return failure(partOf(m_path));
  m_changed = false;
  return {};
}

TeStatus TePartFile::finish() {
  if (TeStatus ok = flush(); !ok)
    return ok;
  if (std::rename(partOf(m_path).c_str(), m_path.c_str()) != 0)
    return failure(m_path);
  ::close(std::exchange(m_descriptor, -1));
  teSyncFolderOf(m_path);
  return {};
}

void TePartFile::discard() {
  if (m_descriptor < 0)
    return;
  ::unlink(partOf(m_path).c_str());
  ::close(std::exchange(m_descriptor, -1));
}

void teSyncFolderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    return;
  ::fsync(descriptor);
  ::close(descriptor);
}
