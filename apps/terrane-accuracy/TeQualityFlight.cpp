#include "apps/terrane-accuracy/TeQualityFlight.h"

#include "generators/base/TeAllowance.h"
#include "generators/base/TeText.h"
#include "nodes/context/TeContext.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <vector>

namespace {

constexpr double kSpeed = 2;      ///< m/s: what is seen hardly changes
constexpr double kAltitude = 120; ///< metres above the highest ground nearby
constexpr int kFramesOfCost = 9;
constexpr double kLeverage = 1.3; ///< that the finest picture costs more than the coarsest under load
constexpr double kFinest = 0.25;  ///< pixels
constexpr double kCoarsest = 32;

constexpr int kSamples = 129; ///< of a source map: patches of which the inside is most

bool isSoftware(const std::string& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "Software"})
    if (renderer.find(name) != std::string::npos)
      return true;
  return false;
}

} // namespace

TeQualityFlight::~TeQualityFlight() {
  m_renderer.reset();
  m_root = TeNodePtr<SoSeparator>();
  m_stage.reset();
}

TeResult<std::unique_ptr<TeQualityFlight>> TeQualityFlight::create(const TeCommonOptions& common,
                                                                   int radius) {
  TeResult<std::unique_ptr<TeContext>> context =
      TeContext::create(*teContextKind(common.context), common.width, common.height);
  if (!context)
    return context.error();
  TeEngineOptions options;
  options.radius = radius;
  options.terrain.samples = kSamples;
  options.hud = false;
  options.haze = "off";
  TeResult<std::unique_ptr<TeEngineStage>> stage = TeEngineStage::create(options, common);
  if (!stage)
    return stage.error();
  std::unique_ptr<TeQualityFlight> flight(new TeQualityFlight);
  flight->m_context = std::move(*context);
  flight->m_byCpu = isSoftware(flight->m_context->renderer());
  flight->m_stage = std::move(*stage);
  flight->m_root = TeNodePtr<SoSeparator>(new SoSeparator);
  flight->setLoad(1);

  TeEngine& engine = flight->m_stage->engine();
  TeObject* traveller = engine.addObject(std::make_unique<TeObject>("traveller"));
  if (const TeStatus ok = traveller->setPosition({flight->m_stage->start(), kAltitude}); !ok)
    return ok.error();
  if (const TeStatus ok = traveller->setVelocity({0, kSpeed, 0}); !ok)
    return ok.error();
  engine.setActiveObject(traveller);
  engine.setQualityRange(kFinest, kCoarsest);
  engine.setPixelError(1); // so that levels are made from the start
  if (!engine.initialize())
    return TeError{engine.lastError()};
  engine.finishJobs();

  TeResult<std::unique_ptr<TeSceneRenderer>> renderer =
      TeSceneRenderer::create(*flight->m_context, common.width, common.height);
  if (!renderer)
    return renderer.error();
  flight->m_renderer = std::move(*renderer);
  flight->m_renderer->setFitClipPlanes(false);
  flight->m_renderer->setBackground(flight->m_stage->background());
  return flight;
}

void TeQualityFlight::setLoad(double load) {
  const int times = std::max(1, int(std::lround(load)));
  while (m_root->getNumChildren() > times)
    m_root->removeChild(times);
  while (m_root->getNumChildren() < times)
    m_root->addChild(&m_stage->all());
}

double TeQualityFlight::seconds() const {
  if (!m_byCpu)
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

TeResult<double> TeQualityFlight::draw() {
  const double begin = seconds();
  if (const TeStatus ok = m_renderer->draw(m_root.get()); !ok)
    return ok.error();
  return seconds() - begin;
}

TeResult<double> TeQualityFlight::costAt(double pixels) {
  TeEngine& engine = m_stage->engine();
  engine.setPixelError(pixels);
  std::vector<double> costs;
  for (int i = 0; i < kFramesOfCost; ++i) {
    engine.timeTick(0);
    const TeResult<double> drawn = draw();
    if (!drawn)
      return drawn.error();
    engine.frameDrawn(*drawn, *drawn, *drawn);
    costs.push_back(*drawn);
  }
  std::nth_element(costs.begin(), costs.begin() + kFramesOfCost / 2, costs.end());
  return costs[kFramesOfCost / 2];
}

TeResult<double> TeQualityFlight::findRate(double load) {
  if (const TeResult<double> first = costAt(kFinest); !first) // with all uploads
    return first.error();
  const TeResult<double> finest = costAt(kFinest);
  if (!finest)
    return finest.error();
  const TeResult<double> coarsest = costAt(kCoarsest);
  if (!coarsest)
    return coarsest.error();
  if (*finest < kLeverage * load * *coarsest)
    return TeError{teFormat("no goal can be held under %g times the load: a frame takes %.1f ms at %g px and "
                            "%.1f ms at %g px",
                            load, 1000 * *finest, kFinest, 1000 * *coarsest, kCoarsest)};
  return TeEngine::kDrawingShare / std::sqrt(*finest * load * *coarsest);
}

TeResult<TeQualityTrace> TeQualityFlight::run(double rate, const std::vector<TeQualityTrace::Step>& steps,
                                              const Progress& progress) {
  TeEngine& engine = m_stage->engine();
  if (!engine.setFrameRate(rate) || !engine.setQualityGoal(rate))
    return TeError{engine.lastError()};
  TeQualityTrace trace;
  trace.name = "drawn";
  trace.goal = TeEngine::kDrawingShare / rate;
  trace.steps = steps;
  const double start = seconds();
  double last = start;
  while (last - start < steps.back().end) {
    TeQualityTrace::Frame frame;
    const double now = seconds();
    progress(now - start);
    for (const TeQualityTrace::Step& step : steps)
      if (now - start >= step.begin && now - start < step.end)
        frame.load = step.load;
    setLoad(frame.load);
    frame.pixelError = engine.getStatistics().pixelError;
    if (!engine.timeTick(now - last))
      return TeError{engine.lastError()};
    const double cpu = teThreadCpuSeconds();
    const TeResult<double> drawn = draw();
    if (!drawn)
      return drawn.error();
    engine.frameDrawn(now - last, teThreadCpuSeconds() - cpu, *drawn);
    last = now;
    const TeStatistics& statistics = engine.getStatistics();
    frame.seconds = statistics.drawing.seconds;
    frame.bound = statistics.errorBoundPixels;
    frame.triangles = statistics.drawing.triangles;
    frame.time = seconds() - start;
    trace.frames.push_back(frame);
  }
  setLoad(1);
  return trace;
}
