#include "apps/terrane-accuracy/TePlot.h"

#include "generators/base/TePartFile.h"
#include "generators/base/TeText.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

namespace {

const char* kProgram = "gnuplot";

/// In gnuplot's single quotes, which know no escapes but the quote doubled.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text)
    result += letter == '\'' ? std::string("''") : std::string(1, letter);
  return result + '\'';
}

/// Where the shell would find it; empty if nowhere.
std::string programPath() {
  const char* path = std::getenv("PATH");
  std::string rest = path ? path : "";
  while (!rest.empty()) {
    const std::size_t end = rest.find(':');
    const std::string file = rest.substr(0, end) + '/' + kProgram;
    if (access(file.c_str(), X_OK) == 0)
      return file;
    rest = end == std::string::npos ? std::string() : rest.substr(end + 1);
  }
  return {};
}

TeStatus run(const std::string& program, const std::string& script) {
  const pid_t child = fork();
  if (child == 0) {
    execl(program.c_str(), kProgram, script.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
    ;
  if (child < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return TeError{script + ": gnuplot failed"};
  return {};
}

/// Told apart on white, also by those who do not see all colours, with the marks beside them.
const char* const kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                "#000000", "#e69f00", "#56b4e9", "#8b0000"};
constexpr int kMarks[] = {5, 7, 9, 11, 13, 4, 6, 8};
constexpr std::size_t kStyles = sizeof kMarks / sizeof *kMarks;

std::string style(std::size_t i) {
  return std::string(" linewidth 2 linecolor rgb '") + kColours[i % kStyles] + "'";
}

bool drawable(double value, bool logarithmic) { return std::isfinite(value) && (!logarithmic || value > 0); }

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// gnuplot chooses the range unless there is but one value.
  std::string range(const char* axis) const {
    if (low != high)
      return {};
    return std::string("set ") + axis + "range [" + teNumberText(low == 0 ? -1 : 0.5 * low) + ":" +
           teNumberText(low == 0 ? 1 : 2 * low) + "]\n";
  }
};

} // namespace

std::string TePlot::script(const std::string& terminal, const std::string& output) const {
  std::string text = "set terminal " + terminal + " size 960,640\n";
  text += "set output " + quoted(output) + "\n";
  text += "set title " + quoted(title) + " noenhanced\n";
  text += "set xlabel " + quoted(xLabel) + " noenhanced\nset ylabel " + quoted(yLabel) + " noenhanced\n";
  text += "set grid\nset key outside right top noenhanced\n";
  if (logX)
    text += "set logscale x\n";
  if (logY)
    text += "set logscale y\n";
  std::string curveList;
  Extent xs, ys;
  for (std::size_t i = 0; i < curves.size(); i++) {
    const Curve& curve = curves[i];
    std::string points;
    for (std::size_t point = 0; point < curve.x.size(); point++)
      if (drawable(curve.x[point], logX) && drawable(curve.y[point], logY)) {
        xs.add(curve.x[point]);
        ys.add(curve.y[point]);
        points += teNumberText(curve.x[point]) + ' ' + teNumberText(curve.y[point]) + '\n';
      }
    if (points.empty())
      continue;
    const std::string block = "$curve" + std::to_string(i);
    text += block + " << END\n" + points + "END\n";
    curveList += (curveList.empty() ? "" : ", ") + block +
                 (markers ? " with linespoints pointtype " + std::to_string(kMarks[i % kStyles])
                          : std::string(" with lines")) +
                 style(i) + " title " + quoted(curve.name);
  }
  for (std::size_t i = 0; i < lines.size() && !curveList.empty(); i++) {
    if (!drawable(lines[i].x, logX))
      continue;
    xs.add(lines[i].x);
    const std::string block = "$line" + std::to_string(i);
    const std::string x = teNumberText(lines[i].x) + ' ';
    text += block + " << END\n" + x + teNumberText(ys.low) + '\n' + x + teNumberText(ys.high) + "\nEND\n";
    curveList += ", " + block + " with lines dashtype 2" + style(curves.size() + i) + " title " +
                 quoted(lines[i].name);
  }
  text += xs.range("x") + ys.range("y");
  return curveList.empty() ? std::string() : text + "plot " + curveList + "\n";
}

TeStatus TePlot::write(const std::string& file) const {
  const std::string program = programPath();
  if (program.empty())
    return TeError{file + ".svg: not drawn, as the program gnuplot is not installed"};
  const std::string script =
      this->script("svg background rgb 'white'", file + ".svg") + this->script("png", file + ".png");
  if (script.empty())
    return TeError{file + ".svg: not drawn, as there is no point in the diagram"};
  if (const TeStatus ok = TePartFile::writeWhole(file + ".gp", script); !ok)
    return ok;
  for (const char* kind : {".svg", ".png"}) {
    std::error_code ignored;
    std::filesystem::remove(file + kind, ignored);
  }
  if (const TeStatus ok = run(program, file + ".gp"); !ok)
    return ok;
  for (const char* kind : {".svg", ".png"})
    if (!std::filesystem::exists(file + kind))
      return TeError{file + kind + ": gnuplot has not written it"};
  return {};
}

bool TePlot::available() { return !programPath().empty(); }
