#include "generators/elevation/TeClassicNetCdf.h"

#include "generators/elevation/TePlainFile.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace {

constexpr std::uint64_t kMaxHeader = 4 << 20;

constexpr int kDimensions = 10;
constexpr int kVariables = 11;
constexpr int kAttributes = 12;

/// Bytes of a value of a type (1 .. 11), 0 for a type that does not exist.
std::uint64_t bytesOf(std::uint64_t type) {
  static const std::uint64_t bytes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
  return type < std::size(bytes) ? bytes[type] : 0;
}

/// Sum and product, or the largest number if they are larger.
std::uint64_t sum(std::uint64_t a, std::uint64_t b) { return a > UINT64_MAX - b ? UINT64_MAX : a + b; }
std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > UINT64_MAX / b ? UINT64_MAX : a * b;
}

std::uint64_t padded(std::uint64_t bytes) { return sum(bytes, (4 - bytes % 4) % 4); }

struct Variable {
  std::uint64_t bytes = 0; ///< of one record, if it has records
  std::uint64_t begin = 0;
  bool record = false;
};

/// Reads a header front to back; after a failure everything reads as zero.
class HeaderReader {
public:
  explicit HeaderReader(std::vector<unsigned char> bytes)
      : m_bytes(std::move(bytes)), m_version(m_bytes[3]) {}

  bool read() {
    m_at = 4;
    m_records = count();
    if (list(kDimensions) > 0)
      for (std::uint64_t left = m_count; left > 0 && m_good; --left) {
        name();
        m_dimensions.push_back(count());
      }
    attributes();
    if (list(kVariables) > 0)
      for (std::uint64_t left = m_count; left > 0 && m_good; --left)
        variable();
    return m_good;
  }

  /// Bytes that the file must have.
  std::uint64_t extent() const {
    std::uint64_t recordBytes = 0;
    std::uint64_t recordVariables = 0;
    for (const Variable& v : m_variables)
      if (v.record) {
        recordBytes = sum(recordBytes, padded(v.bytes));
        ++recordVariables;
      }
    std::uint64_t end = m_at;
    for (const Variable& v : m_variables) {
      std::uint64_t bytes = v.bytes;
      if (v.record) {
        const std::uint64_t step = recordVariables == 1 ? v.bytes : recordBytes;
        const bool unknown = m_records == (m_version == 5 ? UINT64_MAX : 0xFFFFFFFFu);
        bytes = m_records == 0 || unknown ? 0 : sum(product(step, m_records - 1), v.bytes);
      }
      end = std::max(end, sum(v.begin, bytes));
    }
    return end;
  }

private:
  std::uint64_t number(int bytes) {
    if (!m_good || m_bytes.size() - m_at < std::size_t(bytes)) {
      m_good = false;
      return 0;
    }
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i)
      value = value << 8 | m_bytes[m_at++];
    return value;
  }
  std::uint64_t count() { return number(m_version == 5 ? 8 : 4); }

  void skip(std::uint64_t bytes) {
    if (!m_good || m_bytes.size() - m_at < bytes)
      m_good = false;
    else
      m_at += std::size_t(bytes);
  }
  void name() { skip(padded(std::min(count(), kMaxHeader))); }

  /// Reads the head of a list of one kind, or of none; the number of its elements goes to m_count.
  std::uint64_t list(std::uint64_t kind) {
    const std::uint64_t found = number(4);
    m_count = count();
    if (found != kind && (found != 0 || m_count != 0))
      m_good = false;
    return m_good ? m_count : m_count = 0;
  }

  void attributes() {
    for (std::uint64_t left = list(kAttributes); left > 0 && m_good; --left) {
      name();
      const std::uint64_t type = number(4);
      skip(padded(std::min(product(count(), bytesOf(type)), kMaxHeader)));
    }
  }

  void variable() {
    Variable variable;
    name();
    variable.bytes = 1;
    const std::uint64_t dimensions = count();
    for (std::uint64_t i = 0; i < dimensions && m_good; ++i) {
      const std::uint64_t id = count();
      if (id >= m_dimensions.size()) {
        m_good = false;
        return;
      }
      if (i == 0 && m_dimensions[id] == 0)
        variable.record = true;
      else
        variable.bytes = product(variable.bytes, m_dimensions[id]);
    }
    attributes();
    variable.bytes = product(variable.bytes, bytesOf(number(4)));
    count(); // the size in the header, which is not to be relied on
    variable.begin = number(m_version == 1 ? 4 : 8);
    m_variables.push_back(variable);
  }

  std::vector<unsigned char> m_bytes;
  int m_version;
  std::size_t m_at = 0;
  bool m_good = true;
  std::uint64_t m_count = 0;
  std::uint64_t m_records = 0;
  std::vector<std::uint64_t> m_dimensions;
  std::vector<Variable> m_variables;
};

} // namespace

TeStatus teCheckClassicNetCdf(const std::string& path) {
  const TeResult<TePlainFile> file = TePlainFile::open(path);
  if (!file)
    return file.error();
  std::vector<unsigned char> bytes(std::size_t(std::min(file->bytes(), kMaxHeader)));
  if (TeStatus ok = file->read(0, bytes.data(), bytes.size()); !ok)
    return ok;
  if (bytes.size() < 4 || std::memcmp(bytes.data(), "CDF", 3) != 0)
    return {};
  HeaderReader header(std::move(bytes));
  if (!header.read())
    return TeError{path + ": its netCDF header is damaged or cut off"};
  if (header.extent() > file->bytes())
    return TeError{path + ": " + std::to_string(file->bytes()) + " bytes, but its variables need " +
                   std::to_string(header.extent()) + ": cut off"};
  return {};
}
