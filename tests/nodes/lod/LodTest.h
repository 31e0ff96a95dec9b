#pragma once

#include "nodes/lod/LodViews.h"
#include "nodes/lod/TeLodMethods.h"
#include "nodes/lod/TeMeshGaps.h"
#include "nodes/lod/TeScreenError.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

/// Registers `body` once for each LOD method, as SUITE.NAME/METHOD.
inline bool registerLodTest(const char* suite, const char* name, const char* file, int line,
                            void (*body)(const std::string& method)) {
  class MethodTest : public testing::Test {
  public:
    MethodTest(void (*body)(const std::string&), std::string method)
        : m_body(body), m_method(std::move(method)) {}
    void TestBody() override { m_body(m_method); }

  private:
    void (*m_body)(const std::string&);
    std::string m_method;
  };
  for (const std::string& method : TeLodMethods::names())
    testing::RegisterTest(suite, (std::string(name) + '/' + method).c_str(), nullptr, nullptr, file, line,
                          [=]() -> testing::Test* { return new MethodTest(body, method); });
  return true;
}

/// LOD_TEST(Suite, Name) { … uses `name` of a method … }
#define LOD_TEST(suite, test)                                                                                \
  static void suite##test(const std::string& name);                                                          \
  static const bool suite##test##Registered =                                                                \
      registerLodTest(#suite, #test, __FILE__, __LINE__, suite##test);                                       \
  static void suite##test([[maybe_unused]] const std::string& name)

inline TeLodFieldPtr lodField(TeHeightMap map, const TeLodField::Placement& placement = {}) {
  return TeLodField::create(std::make_shared<const TeHeightMap>(std::move(map)), placement).value();
}

inline std::unique_ptr<TeLodMethod> lodMethod(const std::string& name, const TeLodFieldPtr& field) {
  TeResult<std::unique_ptr<TeLodMethod>> method = TeLodMethods::create(name, field);
  EXPECT_TRUE(method) << method.error().message;
  return method ? std::move(*method) : nullptr;
}

/// Whether a method says how wrong it is. The midpoint error of RTIN is none that bounds (docs/rtin.md);
/// it is there to be compared with.
inline bool statesBounds(const std::string& name) { return name != "rtin-midpoint"; }

/// The triangles of the last selection of a method and all that can be said of them.
class LodFrame {
public:
  explicit LodFrame(const TeLodFieldPtr& field)
      : m_field(field), m_gaps(field),
        m_error(field->heights(), field->placement().corner, field->spacing(), field->heightScale()) {}

  /// Fetches them, replacing earlier ones.
  void take(const TeLodMethod& method) {
    m_mesh.clear();
    method.appendMesh(m_mesh);
    m_selection = &method.selection();
    m_statesBounds = statesBounds(method.name());
  }
  const TeLodMesh& mesh() const { return m_mesh; }
  std::int64_t gaps(const TeLodView& view) { return m_gaps.count(m_mesh, view); }
  /// Triangles of no area, or seen from below.
  std::int64_t slivers() const {
    std::int64_t slivers = 0;
    for (std::size_t i = 0; i < m_mesh.indices.size(); i += 3)
      slivers += doubleArea(i) <= 0;
    return slivers;
  }
  /// Twice the area of all triangles, cells.
  std::int64_t doubleArea() const {
    std::int64_t area = 0;
    for (std::size_t i = 0; i < m_mesh.indices.size(); i += 3)
      area += doubleArea(i);
    return area;
  }
  /// Over all samples that are safely in view.
  TeScreenError::Report errors(TeLodView view) {
    for (glm::dvec4& plane : view.planes)
      plane.w -= 1e-6 * m_field->spacing();
    m_error.clear();
    for (std::size_t i = 0; i < m_mesh.indices.size(); i += 3)
      m_error.add(corner(i), corner(i + 1), corner(i + 2));
    return m_error.measure(view);
  }
  /// What a report may exceed a bound by, as heights are rounded to float when they are morphed.
  double rounding(const TeLodView& view, const TeScreenError::Report& report) const {
    const double largest = std::max(std::fabs(m_field->lowest()), std::fabs(m_field->highest()));
    const glm::dvec3 worst = m_field->position(m_field->vertex(report.worstColumn, report.worstRow));
    return view.pixels(0x1p-22 * largest * m_field->heightScale(), glm::distance(view.eye, worst));
  }
  /// Each sample in view is drawn once, without gaps, and is off by no more than the selection says.
  void expectRight(const TeLodView& view, const TeLodAccuracy& accuracy) {
    expectRight(view, view, accuracy);
  }
  /// The same for a true camera that is not where the method was told, but within its slack.
  void expectRight(const TeLodView& told, const TeLodView& view, const TeLodAccuracy& accuracy) {
    ASSERT_EQ(m_mesh.triangles(), m_selection->triangles);
    ASSERT_EQ(gaps(view), 0);
    const TeScreenError::Report report = errors(view);
    ASSERT_EQ(report.uncovered, 0);
    ASSERT_EQ(report.overlaps, 0);
    ASSERT_EQ(report.foreign, 0);
    ASSERT_FALSE(std::isnan(m_selection->errorBound));
    ASSERT_LE(report.worst, m_selection->errorBound * (1 + 1e-6) + rounding(view, report))
        << "wanted " << accuracy.pixelError << " at " << told.eye.x << " " << told.eye.y << " " << told.eye.z;
    if (m_statesBounds && accuracy.pixelError > 0 && !(accuracy.dial > 0) && m_selection->coarsening == 1) {
      ASSERT_LE(m_selection->errorBound, accuracy.pixelError * (1 + 1e-6));
    }
    lastWorst = report.worst;
  }

  double lastWorst = 0; ///< pixels, of expectRight()

private:
  const TeLodVertex& corner(std::size_t index) const { return m_mesh.vertices[m_mesh.indices[index]]; }
  std::int64_t doubleArea(std::size_t first) const {
    const TeLodVertex &a = corner(first), &b = corner(first + 1), &c = corner(first + 2);
    return std::int64_t(b.column - a.column) * (c.row - a.row) -
           std::int64_t(c.column - a.column) * (b.row - a.row);
  }

  TeLodFieldPtr m_field;
  TeMeshGaps m_gaps;
  TeScreenError m_error;
  TeLodMesh m_mesh;
  const TeLodSelection* m_selection = nullptr;
  bool m_statesBounds = true;
};

/// A camera as a demo or an adversary may have it.
template <class Random> TeLodView anyView(Random& random, const TeLodField& field) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double side = field.cells() * field.spacing();
  const double relief =
      std::max(1.0, (double(field.highest()) - double(field.lowest())) * field.heightScale());
  TeLodView view = viewFrom(field.placement().corner + anyEye(random, side, relief), uniform(100, 3000));
  view.eye.z += double(field.lowest()) * field.heightScale();
  if (random() % 4 != 0)
    lookAlong(view, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 0.3)}, uniform(0.05, 1.4));
  view.perspective = random() % 8 != 0;
  if (!view.perspective)
    view.focal = uniform(0.01, 10);
  return view;
}

/// Wanted errors from a part of a pixel to hundreds, morphed or not.
template <class Random> TeLodAccuracy anyAccuracy(Random& random, const TeLodMethod& method) {
  TeLodAccuracy accuracy;
  accuracy.pixelError = std::exp(std::uniform_real_distribution<double>(-1, 5)(random));
  accuracy.geomorph = method.morphs() && random() % 2 == 0;
  if (random() % 40 == 0)
    accuracy.pixelError = 0;
  return accuracy;
}
