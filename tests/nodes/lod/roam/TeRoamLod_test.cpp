#include "nodes/lod/roam/TeRoamLod.h"

#include "nodes/lod/TeFlyover.h"
#include "nodes/lod/TeLodMethods.h"
#include "nodes/lod/TeScreenError.h"
#include "nodes/lod/lodTrials.h"
#include "nodes/lod/roam/RoamCheck.h"

#include <cmath>

namespace {

/// Rough at every scale, like real terrain.
TeLodFieldPtr hills(int cells) {
  TeHeightMap map = TeHeightMap::create(cells + 1, cells + 1).value();
  std::mt19937 random(31);
  for (int y = 0; y <= cells; y++)
    for (int x = 0; x <= cells; x++)
      map.at(x, y) = float(180 * std::sin(x / 37.0) * std::cos(y / 29.0) + 25 * std::sin(x / 5.0 + y / 7.0) +
                           double(random() % 1000) * 0.004);
  TeLodField::Placement placement;
  placement.spacing = 10;
  return TeLodField::create(std::make_shared<const TeHeightMap>(std::move(map)), placement).value();
}

TeFlyover flightOver(const TeLodFieldPtr& field) {
  TeFlyover flight;
  flight.cells = field->cells();
  flight.spacing = field->spacing();
  flight.heightScale = field->heightScale();
  flight.sample = [field](std::int32_t column, std::int32_t row) { return field->height(column, row); };
  return flight;
}

TeLodAccuracy within(double pixels) {
  TeLodAccuracy accuracy;
  accuracy.pixelError = pixels;
  return accuracy;
}

TeLodAccuracy triangles(double count) {
  TeLodAccuracy accuracy;
  accuracy.dial = count;
  return accuracy;
}

TeScreenError::Report measured(const TeLodMethod& lod, const TeLodView& view) {
  const TeLodField& field = lod.field();
  TeScreenError error(field.heights(), field.placement().corner, field.spacing(), field.heightScale());
  TeLodMesh mesh;
  lod.appendMesh(mesh);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    error.add(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
              mesh.vertices[mesh.indices[i + 2]]);
  return error.measure(view);
}

} // namespace

TEST(TeRoamLod, isOneOfTheMethods) {
  const auto made = TeLodMethods::create("roam", hills(16));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ((*made)->name(), "roam");
  EXPECT_EQ((*made)->dial().name, "triangles");
}

TEST(TeRoamLod, fromOtherViewsItIsTheSameAsFromScratch) {
  std::mt19937 random(32);
  for (const StressField stress : {StressField::Rough, StressField::Cliff, StressField::Checkerboard})
    for (const TeRoamMetric metric :
         {TeRoamMetric::ScreenError, TeRoamMetric::Variance, TeRoamMetric::ScaledVariance}) {
      TeRoamLod::Settings settings;
      settings.metric = metric;
      TeRoamLod::Settings only = settings;
      only.splitOnly = true;
      const TeLodFieldPtr field = stressTerrain(stress, 64, random);
      const auto bounds = TeRoamBounds::create(field, true);
      TeRoamLod kept(bounds, field, settings), simple(bounds, field, only);
      for (int jump = 0; jump < 40; jump++) {
        const TeLodView view = anyView(*field, random);
        const TeLodAccuracy accuracy =
            within(random() % 20 == 0 ? 0 : std::exp(double(random() % 100) / 15 - 1));
        TeRoamLod anew(bounds, field, settings);
        for (TeRoamLod* lod : {&kept, &anew, &simple})
          ASSERT_TRUE(lod->select(view, accuracy));
        ASSERT_EQ(splitTriangles(kept.mesh()), splitTriangles(anew.mesh())) << jump;
        ASSERT_EQ(splitTriangles(simple.mesh()), splitTriangles(anew.mesh())) << jump;
        ASSERT_EQ(kept.selection().errorBound, anew.selection().errorBound);
        ASSERT_EQ(kept.selection().triangles, anew.selection().triangles);
      }
    }
}

TEST(TeRoamLod, errorIsWithinTheBoundAndTheBoundWithinWhatIsWanted) {
  std::mt19937 random(33);
  std::int64_t samples = 0;
  for (int stress = 0; stress <= int(StressField::Flat); stress++) {
    const TeLodFieldPtr field = stressTerrain(StressField(stress), 64, random);
    const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field);
    for (int camera = 0; camera < 60; camera++) {
      TeLodView view = anyView(*field, random);
      const double wanted = std::exp(double(random() % 100) / 15 - 2);
      lod->select(view, within(wanted));
      ASSERT_LE(lod->selection().errorBound, wanted);
      // The true eye may be nearer by the slack.
      if (view.slack > 0) {
        const double angle = double(random() % 628) / 100;
        view.eye += 0.999 * view.slack * glm::dvec3(std::cos(angle), std::sin(angle), 0);
      }
      const TeScreenError::Report report = measured(*lod, view);
      ASSERT_LE(report.worst, lod->selection().errorBound * (1 + 1e-9) + 1e-9);
      ASSERT_EQ(report.uncovered, 0);
      ASSERT_EQ(report.overlaps, 0);
      ASSERT_EQ(report.foreign, 0);
      ASSERT_EQ(report.triangles, lod->selection().triangles);
      samples += report.samples;
    }
  }
  EXPECT_GT(samples, 100000);
}

TEST(TeRoamLod, boundsHoldWhereverTheTerrainLies) {
  std::mt19937 random(36);
  expectThatBoundsHold([](const TeLodFieldPtr& field) { return TeRoamLod::create(field); }, random);
}

TEST(TeRoamLod, zeroPixelsAreAllSamplesInView) {
  std::mt19937 random(34);
  for (int stress = 0; stress <= int(StressField::Flat); stress++) {
    const TeLodFieldPtr field = stressTerrain(StressField(stress), 32, random);
    const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field);
    lod->select(viewFrom({5, 40, 300}), within(0));
    EXPECT_EQ(lod->selection().triangles, 2 * 32 * 32);
    EXPECT_EQ(lod->selection().errorBound, 0);
    TeLodMesh mesh;
    lod->appendMesh(mesh);
    EXPECT_EQ(mesh.vertices.size(), 33u * 33u);
    for (int camera = 0; camera < 10; camera++) {
      const TeLodView view = anyView(*field, random);
      lod->select(view, within(0));
      EXPECT_EQ(measured(*lod, view).worst, 0);
      EXPECT_EQ(lod->selection().errorBound, 0);
    }
  }
}

TEST(TeRoamLod, holdsItsNumberOfTrianglesOnAFlight) {
  const TeLodFieldPtr field = hills(512);
  const TeFlyover flight = flightOver(field);
  const auto bounds = TeRoamBounds::create(field, false);
  for (const double wanted : {1000.0, 3000.0, 20000.0}) {
    TeRoamLod lod(bounds, field, {});
    lod.select(flight.view(0).lodView(), triangles(wanted));
    std::int64_t changes = 0, least = 1 << 30, most = 0;
    for (int frame = 1; frame <= 90; frame++) {
      ASSERT_TRUE(lod.select(flight.view(frame).lodView(), triangles(wanted)));
      const TeLodSelection& selection = lod.selection();
      changes += selection.splits + selection.merges;
      least = std::min(least, selection.triangles);
      most = std::max(most, selection.triangles);
      // Neither queue has much better to offer than the other.
      ASSERT_LE(lod.mesh().splits().topPriority(), 2 * lod.mesh().merges().topPriority()) << frame;
    }
    std::printf("%6.0f triangles: %lld .. %lld, %.1f splits and merges a frame\n", wanted,
                static_cast<long long>(least), static_cast<long long>(most), double(changes) / 90);
    EXPECT_GE(double(least), 0.95 * wanted);
    EXPECT_LE(double(most), wanted);
    EXPECT_LT(double(changes) / 90, 0.1 * wanted);
  }
}

TEST(TeRoamLod, aTremblingCameraSwitchesNothing) {
  const TeLodFieldPtr field = hills(256);
  const TeFlyover flight = flightOver(field);
  for (const TeLodAccuracy& accuracy : {triangles(3000), within(4)}) {
    const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field);
    std::int64_t changes = 0;
    for (int frame = 0; frame < 1000; frame++) {
      TePerspectiveView view = flight.view(7);
      view.eye.x += frame % 2 ? 1e-7 : -1e-7;
      lod->select(view.lodView(), accuracy);
      changes += frame < 2 ? 0 : lod->selection().splits + lod->selection().merges;
    }
    EXPECT_LE(changes, 1);
  }
}

TEST(TeRoamLod, keepsTheBudgetAndSaysWhatThatCosts) {
  const TeLodFieldPtr field = hills(256);
  const TeFlyover flight = flightOver(field);
  for (const bool splitOnly : {false, true}) {
    TeRoamLod::Settings settings;
    settings.splitOnly = splitOnly;
    const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field, settings);
    for (const double pixels : {0.0, 1.0})
      for (int frame = 0; frame < 200; frame += 10) {
        TeLodAccuracy accuracy = within(pixels);
        accuracy.maxTriangles = 2000;
        ASSERT_TRUE(lod->select(flight.view(frame).lodView(), accuracy));
        ASSERT_LE(lod->selection().triangles, 2000);
        ASSERT_GE(lod->selection().triangles, 1800);
        ASSERT_GT(lod->selection().errorBound, pixels);
        ASSERT_GE(lod->selection().coarsening * std::max(pixels, 1.0 / 64),
                  0.999 * lod->selection().errorBound);
        ASSERT_LE(measured(*lod, flight.view(frame).lodView()).worst, lod->selection().errorBound);
      }
    lod->select(flight.view(0).lodView(), within(8));
    EXPECT_EQ(lod->selection().coarsening, 1);
  }
}

TEST(TeRoamLod, keepsTheBudgetFromExtremeViews) {
  const TeLodFieldPtr field = hills(256);
  const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field);
  for (const double degrees : {0.001, 1.0, 60.0, 179.0})
    for (const int pixels : {1, 1024})
      for (const bool perspective : {true, false}) {
        TePerspectiveView camera = flightOver(field).view(3);
        camera.fieldOfView = degrees * 3.14159265358979 / 180;
        camera.width = camera.height = pixels;
        TeLodView view = camera.lodView();
        view.perspective = perspective;
        for (const double wanted : {0.0, 1.0}) {
          TeLodAccuracy accuracy = within(wanted);
          accuracy.maxTriangles = 5000;
          ASSERT_TRUE(lod->select(view, accuracy));
          EXPECT_LE(lod->selection().triangles, 5000) << degrees << " " << pixels;
        }
      }
}

TEST(TeRoamLod, slicesComeToTheSameMeshAndFitOnTheWay) {
  std::mt19937 random(35);
  const TeLodFieldPtr field = hills(128);
  const auto bounds = TeRoamBounds::create(field, false);
  for (const bool splitOnly : {false, true}) {
    TeRoamLod::Settings settings;
    settings.splitOnly = splitOnly;
    TeRoamLod sliced(bounds, field, settings), whole(bounds, field, settings);
    for (int jump = 0; jump < 6; jump++) {
      const TeLodView view = flightOver(field).view(jump * 60).lodView();
      whole.select(view, within(2));
      int slices = 0;
      for (bool done = false; !done; slices++) {
        TeAllowance some = TeAllowance::units(40);
        done = sliced.select(view, within(2), some);
        const TeLodSelection& selection = sliced.selection();
        ASSERT_EQ(done, selection.complete);
        ASSERT_LE(some.unitsSpent(), 40 + 30); // a split and the coarser neighbours before it
        TeWatertight mesh(field->cells());
        addAllLeaves(sliced.mesh(), mesh);
        ASSERT_EQ(mesh.cracks() + mesh.slivers(), 0);
        ASSERT_TRUE(mesh.coversSquare());
        if (slices % 16 == 0) {
          ASSERT_LE(measured(sliced, view).worst, selection.errorBound * (1 + 1e-9));
        }
        ASSERT_LT(slices, 100000);
      }
      EXPECT_GT(slices, 5);
      EXPECT_EQ(splitTriangles(sliced.mesh()), splitTriangles(whole.mesh()));
    }
  }
}

TEST(TeRoamLod, aMovingViewIsFollowedWithinItsSlices) {
  const TeLodFieldPtr field = hills(256);
  const TeFlyover flight = flightOver(field);
  const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field);
  int complete = 0;
  for (int frame = 0; frame < 300; frame++) {
    TeAllowance some = TeAllowance::units(400);
    complete += lod->select(flight.view(frame).lodView(), within(4), some);
  }
  EXPECT_GT(complete, 200);
}

TEST(TeRoamLod, slicesOfTimeEndSoonAfterTheirTime) {
  const TeLodFieldPtr field = hills(256);
  const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field);
  const TeLodView view = flightOver(field).view(5).lodView();
  int slices = 0;
  for (bool done = false; !done; slices++) {
    double now = 0; // a clock that each look moves on by a millisecond
    TeAllowance some = TeAllowance::seconds(0.01, [&now] { return now += 0.001; });
    done = lod->select(view, within(2), some);
    ASSERT_LE(now, 0.015);
    ASSERT_LT(slices, 10000);
  }
  EXPECT_GT(slices, 3);
}

TEST(TeRoamLod, theKeyChangesWithTheMeshOnly) {
  const TeLodFieldPtr field = hills(128);
  const TeFlyover flight = flightOver(field);
  const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field);
  const auto select = [&](const TeLodView& view) {
    lod->select(view, within(4));
    TeLodMesh mesh;
    lod->appendMesh(mesh);
    return std::pair(lod->selection().parts[0].key, mesh.indices);
  };
  auto [key, indices] = select(flight.view(0).lodView());
  int same = 0, other = 0;
  for (int frame = 1; frame < 400; frame++) {
    TePerspectiveView view = flight.view(0);
    view.eye.x += frame * 0.02;
    const auto [nextKey, nextIndices] = select(view.lodView());
    if (nextKey == key) {
      ASSERT_EQ(nextIndices, indices);
      same++;
    } else {
      other++;
    }
    key = nextKey;
    indices = nextIndices;
  }
  EXPECT_GT(same, 20);
  EXPECT_GT(other, 5);
}

TEST(TeRoamLod, indicesFollowWhatThePartIsAppendedTo) {
  const TeLodFieldPtr field = hills(32);
  const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field);
  lod->select(viewFrom({100, 100, 400}), within(2));
  TeLodMesh once, twice;
  lod->appendMesh(once);
  lod->appendMesh(twice);
  lod->appendMesh(twice);
  ASSERT_EQ(twice.vertices.size(), 2 * once.vertices.size());
  ASSERT_EQ(twice.indices.size(), 2 * once.indices.size());
  for (std::size_t i = 0; i < once.indices.size(); i++) {
    ASSERT_EQ(twice.indices[i], once.indices[i]);
    ASSERT_EQ(twice.indices[once.indices.size() + i], once.indices[i] + once.vertices.size());
  }
  std::vector<char> used(once.vertices.size(), 0);
  for (const std::uint32_t index : once.indices)
    used[index] = 1;
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
}

// The document's priorities are no bounds; the error reported is one all the same.
TEST(TeRoamLod, theDocumentsFormulasOrderByVarianceAndDistance) {
  const TeLodFieldPtr field = hills(128);
  const auto bounds = TeRoamBounds::create(field, true);
  const TeLodView view = flightOver(field).view(3).lodView();
  TeRoamLod::Settings plain, scaled;
  plain.metric = TeRoamMetric::Variance;
  scaled.metric = TeRoamMetric::ScaledVariance;
  TeRoamLod first(bounds, field, plain), second(bounds, field, scaled);
  for (TeRoamLod* lod : {&first, &second}) {
    lod->select(view, triangles(1000));
    EXPECT_LE(lod->selection().triangles, 1000);
    EXPECT_GE(lod->selection().triangles, 950);
    EXPECT_EQ(RoamCheck(lod->mesh()).fault(), "");
    EXPECT_LE(measured(*lod, view).worst, lod->selection().errorBound);
  }
  EXPECT_EQ(splitTriangles(first.mesh()), splitTriangles(second.mesh()));
  EXPECT_NEAR(second.mesh().splits().topPriority() / first.mesh().splits().topPriority(), 2 * 1280, 0.1);

  // The formula itself, at a base triangle from far away: nothing clamps it.
  TeRoamMesh mesh(bounds, TeRoamMetric::Variance, true);
  const TeLodView far = viewFrom({3000, 5000, 90000});
  mesh.setView(far, 0);
  const glm::dvec3 centroid = (field->position(field->vertex(0, 0)) + field->position(field->vertex(128, 0)) +
                               field->position(field->vertex(128, 128))) /
                              3.0;
  EXPECT_NEAR(mesh.priority(0),
              double(bounds->variance({0, 0, 0, false}, 0)) / glm::distance(centroid, far.eye), 1e-9);
}

TEST(TeRoamLod, memoryFollowsTheMesh) {
  const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(hills(512));
  EXPECT_LT(lod->bytesPerSample(), 6.1);
  lod->select(viewFrom({2000, 2000, 800}), triangles(20000));
  EXPECT_GT(lod->bytesPerSample(), 6.1);
}
