// Frames of Seamless Patches against plain OpenGL that draws the same triangles: one vertex buffer with
// normals, one of indices, fixed functions, the same light. Both within Coin, at 1024×768. The least of
// several frames each, in turns: by the wall clock, and CPU time of all threads, which other programs disturb
// less.

#include "bench/scene/benchContext.h"
#include "nodes/TeNodePtr.h"
#include "nodes/TeSceneRenderer.h"
#include "nodes/lod/TePerspectiveView.h"
#include "nodes/seamless/TeSeamlessDrawing.h"
#include "nodes/seamless/TeSeamlessRenderer.h"
#include "nodes/seamless/TeSeamlessTerrain.h"

#include <Inventor/SbMatrix.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoGLLazyElement.h>
#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoProjectionMatrixElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/misc/SoState.h>
#include <Inventor/nodes/SoCallback.h>
#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include <benchmark/benchmark.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <memory>
#include <unordered_map>
#include <vector>

namespace {

constexpr int kWidth = 1024;
constexpr int kHeight = 768;
constexpr int kResolution = 1024;
constexpr double kSpacing = 10;

std::shared_ptr<const TeHeightMap> hills() {
  static std::shared_ptr<const TeHeightMap> made;
  if (made)
    return made;
  TeHeightMap map = std::move(*TeHeightMap::create(kResolution + 1, kResolution + 1));
  for (int y = 0; y <= kResolution; y++)
    for (int x = 0; x <= kResolution; x++)
      map.at(x, y) = float(180 * std::sin(x / 60.0) * std::cos(y / 70.0) +
                           40 * std::sin(x / 13.0 + y / 17.0) + 5 * std::cos(x / 3.0 - y / 4.0));
  made = std::make_shared<const TeHeightMap>(std::move(map));
  return made;
}

glm::dmat4 doubles(const SbMatrix& matrix) {
  glm::dmat4 result;
  for (int row = 0; row < 4; row++)
    for (int column = 0; column < 4; column++)
      result[row][column] = double(matrix[row][column]);
  return result;
}

/// Plain OpenGL: interleaved positions and normals, 32-bit indices.
class RawMesh {
public:
  void load(const std::vector<TeSeamlessMesh::Triangle>& triangles) {
    m_gl.load(benchContext->id());
    const auto find = [](const char* name, auto*& function) {
      function =
          reinterpret_cast<std::remove_reference_t<decltype(function)>>(benchContext->procAddress(name));
    };
    find("glVertexPointer", m_vertexPointer);
    find("glNormalPointer", m_normalPointer);
    find("glEnableClientState", m_enableClientState);
    find("glDisableClientState", m_disableClientState);
    find("glDrawElements", m_drawElements);
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
    std::unordered_map<std::int64_t, std::uint32_t> numbers;
    for (const TeSeamlessMesh::Triangle& triangle : triangles)
      for (const TeSeamlessMesh::Vertex& vertex : {triangle.a, triangle.b, triangle.c}) {
        const auto [found, isNew] = numbers.try_emplace(
            std::int64_t(vertex.row) * (kResolution + 1) + vertex.column, std::uint32_t(numbers.size()));
        indices.push_back(found->second);
        if (!isNew)
          continue;
        const glm::vec3 normal = normalAt(vertex.column, vertex.row);
        for (const float value : {float(vertex.column * kSpacing), float(vertex.row * kSpacing),
                                  vertex.height, normal.x, normal.y, normal.z})
          vertices.push_back(value);
      }
    m_count = GLsizei(indices.size());
    m_gl.genBuffers(2, m_buffers);
    m_gl.bindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
    m_gl.bufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * 4), vertices.data(), GL_STATIC_DRAW);
    m_gl.bindBuffer(GL_ARRAY_BUFFER, m_buffers[1]);
    m_gl.bufferData(GL_ARRAY_BUFFER, GLsizeiptr(indices.size() * 4), indices.data(), GL_STATIC_DRAW);
    m_gl.bindBuffer(GL_ARRAY_BUFFER, 0);
  }
  void draw() const {
    m_gl.bindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
    m_vertexPointer(3, GL_FLOAT, 24, nullptr);
    m_normalPointer(GL_FLOAT, 24, reinterpret_cast<const void*>(12));
    m_enableClientState(GL_VERTEX_ARRAY);
    m_enableClientState(GL_NORMAL_ARRAY);
    m_gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[1]);
    m_drawElements(GL_TRIANGLES, m_count, GL_UNSIGNED_INT, nullptr);
    m_disableClientState(GL_VERTEX_ARRAY);
    m_disableClientState(GL_NORMAL_ARRAY);
    m_gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    m_gl.bindBuffer(GL_ARRAY_BUFFER, 0);
  }
  void free() { m_gl.deleteBuffers(2, m_buffers); }

private:
  static glm::vec3 normalAt(int column, int row) {
    const auto at = [](int x, int y) {
      return hills()->at(std::clamp(x, 0, kResolution), std::clamp(y, 0, kResolution));
    };
    const float east = (at(column + 1, row) - at(column - 1, row)) / float(2 * kSpacing);
    const float north = (at(column, row + 1) - at(column, row - 1)) / float(2 * kSpacing);
    return glm::normalize(glm::vec3(-east, -north, 1));
  }

  TeSeamlessGl m_gl;
  void (*m_vertexPointer)(GLint, GLenum, GLsizei, const void*) = nullptr;
  void (*m_normalPointer)(GLenum, GLsizei, const void*) = nullptr;
  void (*m_enableClientState)(GLenum) = nullptr;
  void (*m_disableClientState)(GLenum) = nullptr;
  void (*m_drawElements)(GLenum, GLsizei, GLenum, const void*) = nullptr;
  GLuint m_buffers[2] = {};
  GLsizei m_count = 0;
};

/// A clipmap that holds the one level that is needed, whole.
class WholeClipmap {
public:
  WholeClipmap() {
    const auto texImage3D = reinterpret_cast<PFNGLTEXIMAGE3DPROC>(benchContext->procAddress("glTexImage3D"));
    m_gl.load(benchContext->id());
    m_gl.genTextures(1, &clipmap.texture);
    m_gl.bindTexture(GL_TEXTURE_2D_ARRAY, clipmap.texture);
    m_gl.pixelStorei(GL_UNPACK_ALIGNMENT, 1);
    texImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32F, kResolution + 1, kResolution + 1, 1, 0, GL_RED, GL_FLOAT,
               hills()->data());
    m_gl.pixelStorei(GL_UNPACK_ALIGNMENT, 4);
    m_gl.bindTexture(GL_TEXTURE_2D_ARRAY, 0);
    clipmap.format = TeClipFormat::Float;
    clipmap.clipSize = kResolution + 1;
    clipmap.resolutionLog = clipmap.residency.base = 10;
    clipmap.residency.windows = {{0, 0, kResolution + 1}};
  }
  ~WholeClipmap() { m_gl.deleteTextures(1, &clipmap.texture); }
  WholeClipmap(const WholeClipmap&) = delete;
  WholeClipmap& operator=(const WholeClipmap&) = delete;

  TeSeamlessClipTexture clipmap;

private:
  TeSeamlessGl m_gl;
};

enum Way { Instanced, Classic, Raw };

class Scene {
public:
  Scene(std::int64_t wantedTriangles, TeSeamlessTechnique::Heights heights, bool lit)
      : m_layout(*TeSeamlessLayout::create(kResolution, 16, 3)),
        m_parts(std::make_shared<TeSeamlessParts>(m_layout, true)), m_drawing(m_layout, m_parts),
        m_root(new SoSeparator) {
    m_look.technique = {heights, TeSeamlessTechnique::Color, true};
    m_look.heights = hills();
    m_look.stripColour = {1, 1, 1};
    m_placement.spacing = kSpacing;
    m_placement.range = {-230, 230};
    TePerspectiveView view;
    view.eye = {0.5 * kResolution * kSpacing, 0.08 * kResolution * kSpacing, 700};
    view.forward = glm::normalize(glm::dvec3(0, 1, -0.25));
    view.nearDistance = 20;
    view.farDistance = 20000;
    select(view, wantedTriangles);
    auto* camera = new SoPerspectiveCamera;
    camera->position.setValue(SbVec3f(float(view.eye.x), float(view.eye.y), float(view.eye.z)));
    camera->pointAt(SbVec3f(float(view.eye.x), float(view.eye.y + view.forward.y * 1e4),
                            float(view.eye.z + view.forward.z * 1e4)),
                    SbVec3f(0, 0, 1));
    camera->heightAngle = float(view.fieldOfView);
    camera->nearDistance = float(view.nearDistance);
    camera->farDistance = float(view.farDistance);
    m_root->addChild(camera);
    auto* model = new SoLightModel;
    model->model = lit ? SoLightModel::PHONG : SoLightModel::BASE_COLOR;
    m_root->addChild(model);
    auto* sun = new SoDirectionalLight;
    sun->direction.setValue(-0.3f, 1, -0.8f);
    m_root->addChild(sun);
    auto* terrain = new SoCallback;
    terrain->setCallback(
        [](void* self, SoAction* action) {
          if (action->isOfType(SoGLRenderAction::getClassTypeId()))
            static_cast<Scene*>(self)->render(action->getState());
        },
        this);
    m_root->addChild(terrain);
    m_renderer = std::move(TeSceneRenderer::create(*benchContext, kWidth, kHeight).value());
    m_renderer->setFitClipPlanes(false);
    std::vector<TeSeamlessMesh::Triangle> mesh;
    for (const TeSeamlessPatch& patch : m_selection.patches)
      TeSeamlessMesh::appendPatch(patch, m_layout, *m_parts, TeSeamlessMapHeights(hills().get()), mesh);
    m_raw.load(mesh);
  }
  ~Scene() { m_raw.free(); }

  struct Cost {
    double ms = std::numeric_limits<double>::max();    ///< by the wall clock
    double cpuMs = std::numeric_limits<double>::max(); ///< of all threads
    void lower(const Cost& other) {
      ms = std::min(ms, other.ms);
      cpuMs = std::min(cpuMs, other.cpuMs);
    }
  };
  Cost frame(Way way) {
    m_way = way;
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    if (!m_renderer->draw(m_root.get()))
      std::abort();
    benchContext->gl().finish();
    return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(),
            1e3 * double(std::clock() - cpu) / CLOCKS_PER_SEC};
  }
  std::int64_t triangles() const { return m_selection.triangles; }

private:
  void select(const TePerspectiveView& view, std::int64_t wanted) {
    const TeSeamlessSelector selector(m_layout, nullptr);
    TeSeamlessAccuracy accuracy;
    accuracy.precision = 1;
    do {
      selector.select(view.lodView(), m_placement, accuracy, nullptr, m_selection);
      accuracy.precision *= 1.02;
    } while (m_selection.triangles < wanted && accuracy.precision < 1000);
    m_lists.build(m_selection, m_layout, *m_parts);
  }
  void render(SoState* state) {
    SoGLLazyElement::getInstance(state)->send(state, SoLazyElement::ALL_MASK);
    if (m_way == Raw) {
      m_raw.draw();
      return;
    }
    m_look.technique.instanced = m_way == Instanced;
    TeSeamlessFrame frame(
        m_placement, doubles(SoViewingMatrixElement::get(state)) * doubles(SoModelMatrixElement::get(state)),
        doubles(SoProjectionMatrixElement::get(state)));
    frame.heightClipmap = &m_clipmap.clipmap;
    if (!m_drawing.draw(std::uint32_t(SoGLCacheContextElement::get(state)), m_lists, m_look, frame))
      std::abort();
  }

  TeSeamlessLayout m_layout;
  std::shared_ptr<const TeSeamlessParts> m_parts;
  TeSeamlessDrawing m_drawing;
  TeSeamlessPlacement m_placement;
  TeSeamlessLook m_look;
  TeSeamlessSelection m_selection;
  TeSeamlessLists m_lists;
  TeNodePtr<SoSeparator> m_root;
  std::unique_ptr<TeSceneRenderer> m_renderer;
  RawMesh m_raw;
  WholeClipmap m_clipmap;
  Way m_way = Instanced;
};

/// Arguments: wanted triangles; whether lit; TeSeamlessTechnique::Heights.
void framesAgainstRaw(benchmark::State& state) {
  Scene scene(state.range(0), TeSeamlessTechnique::Heights(state.range(2)), state.range(1) != 0);
  Scene::Cost least[3];
  for (const Way way : {Instanced, Classic, Raw})
    scene.frame(way);
  for (auto _ : state) {
    for (const Way way : {Instanced, Raw, Classic}) {
      const Scene::Cost cost = scene.frame(way);
      least[way].lower(cost);
      if (way == Instanced)
        state.SetIterationTime(cost.ms / 1e3);
    }
  }
  state.counters["triangles"] = double(scene.triangles());
  state.counters["instanced_ms"] = least[Instanced].ms;
  state.counters["classic_ms"] = least[Classic].ms;
  state.counters["raw_ms"] = least[Raw].ms;
  state.counters["ratio"] = least[Instanced].ms / least[Raw].ms;
  state.counters["cpu_ratio"] = least[Instanced].cpuMs / least[Raw].cpuMs;
  state.counters["target"] = 1.15;
}

BENCHMARK(framesAgainstRaw)
    ->ArgsProduct({{88000, 500000}, {1, 0}, {TeSeamlessTechnique::Heightmap, TeSeamlessTechnique::Clipmaps}})
    ->UseManualTime()
    ->Iterations(15)
    ->Unit(benchmark::kMillisecond);

} // namespace
