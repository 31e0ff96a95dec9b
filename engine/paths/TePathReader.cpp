#include "engine/paths/TePathReader.h"

#include "generators/base/TeText.h"

#include <charconv>
#include <cmath>

namespace {

std::vector<std::string_view> wordsOf(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  const std::string_view blanks = " \t\r";
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  return words;
}

bool readNumber(std::string_view word, double& value) {
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, value);
  return read.ec == std::errc() && read.ptr == end && std::isfinite(value);
}

} // namespace

TeError TePathReader::error(const std::string& reason) const {
  return {m_name + ":" + std::to_string(m_line) + ": " + reason};
}

TeStatus TePathReader::readPoint(const std::vector<std::string_view>& words, bool jump) {
  if (words.size() < 3 || words.size() > 4)
    return error("must be x y z [speed], jump x y z [speed], or repeat");
  if (m_points.size() == TePath::kMaxPoints)
    return error("more than " + std::to_string(TePath::kMaxPoints) + " points");
  TePathPoint point;
  point.jump = jump;
  point.aboveGround = words[2].front() == '+';
  if (!m_points.empty())
    point.speed = m_points.back().speed;
  double* const numbers[4] = {&point.place.x, &point.place.y, &point.place.z, &point.speed};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = i == 2 && point.aboveGround ? words[i].substr(1) : words[i];
    if (!readNumber(word, *numbers[i]) || (i == 3 && *numbers[i] == 0))
      return error(teQuoted(words[i]) + " is no " + (i == 3 ? "speed" : "coordinate"));
  }
  const std::string fault = TePath::fault(point, m_points.empty() ? nullptr : &m_points.back());
  if (!fault.empty())
    return error(fault);
  m_points.push_back(point);
  return {};
}

TeStatus TePathReader::readLine(std::string_view line) {
  std::vector<std::string_view> words = wordsOf(line);
  if (words.empty())
    return {};
  if (m_repeats)
    return error("nothing may follow repeat");
  if (words.size() == 1 && words.front() == "repeat") {
    m_repeats = true;
    return {};
  }
  const bool jump = words.front() == "jump";
  if (jump)
    words.erase(words.begin());
  return readPoint(words, jump);
}

TeResult<TePath> TePathReader::read(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    ++m_line;
    if (const TeStatus ok = readLine(text.substr(at, end - at)); !ok)
      return ok.error();
    at = end + 1;
  }
  TeResult<TePath> path = TePath::create(std::move(m_points), m_repeats);
  if (!path)
    return TeError{m_name + ": " + path.error().message};
  return path;
}
