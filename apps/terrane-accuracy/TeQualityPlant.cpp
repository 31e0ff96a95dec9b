#include "apps/terrane-accuracy/TeQualityPlant.h"

#include "engine/quality/TeQuality.h"
#include "generators/base/TeRandom.h"
#include "generators/base/TeText.h"

#include <cassert>
#include <cmath>
#include <deque>

TeQualityTrace TeQualityPlant::run(const std::vector<TeQualityTrace::Step>& steps) const {
  TeQualityTrace trace;
  trace.name = teFormat("simulated, exponent %g", exponent);
  trace.goal = 1 / rate;
  trace.steps = steps;
  TeQuality quality;
  TeStatus ok = quality.setGoal(trace.goal);
  assert(ok);
  ok = quality.setRange(1.0 / 16, 256);
  assert(ok);
  TeRandom random(1, 1, {});
  std::deque<double> chosen;
  double time = 0;
  while (time < steps.back().end) {
    TeQualityTrace::Frame frame;
    for (const TeQualityTrace::Step& step : steps)
      if (time >= step.begin && time < step.end)
        frame.load = step.load;
    frame.pixelError = quality.pixelError();
    chosen.push_back(frame.pixelError);
    while (int(chosen.size()) > delay + 1)
      chosen.pop_front();
    const double cost = fixed + (1 - fixed) * std::pow(chosen.front(), -exponent);
    frame.seconds = trace.goal * frame.load * cost * (1 + noise * random.uniform(-1.0, 1.0));
    time += frame.seconds;
    frame.time = time;
    quality.frameDrawn(frame.seconds);
    trace.frames.push_back(frame);
  }
  return trace;
}
