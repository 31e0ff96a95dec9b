#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/seamless/TeSeamlessDrawing.h"
#include "nodes/seamless/TeSeamlessRenderer.h"
#include "nodes/seamless/TeSeamlessTerrain.h"

#include <GL/gl.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoGLLazyElement.h>
#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoProjectionMatrixElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/misc/SoState.h>
#include <Inventor/nodes/SoCallback.h>

#include <glm/mat4x4.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

inline TeSeamlessLayout seamlessLayout(int resolution, int minResolution, int levels) {
  auto layout = TeSeamlessLayout::create(resolution, minResolution, levels);
  EXPECT_TRUE(layout) << (layout ? "" : layout.error().message);
  return *layout;
}

/// All patches of a tree level, each side with the detail that `detailOf` gives it.
inline TeSeamlessSelection selectLevel(
    const TeSeamlessLayout& layout, int level,
    const std::function<float(const TeSideKey&)>& detailOf = [](const TeSideKey&) { return 0.0f; }) {
  TeSeamlessSelection selection;
  for (std::int32_t y = 0; y < layout.patchesPerSide(level); y++)
    for (std::int32_t x = 0; x < layout.patchesPerSide(level); x++) {
      TeSeamlessPatch patch;
      patch.level = std::int16_t(level);
      patch.x = x;
      patch.y = y;
      for (int side = 0; side < 4; side++)
        patch.detail[std::size_t(side)] = detailOf(TeSeamlessLayout::sideOf(level, x, y, TeSide(side)));
      selection.patches.push_back(patch);
    }
  return selection;
}

/// A detail for every side, from 0 to the top of its level; whole ones, or any.
inline std::function<float(const TeSideKey&)> variedDetail(const TeSeamlessLayout& layout, bool whole) {
  return [layout, whole](const TeSideKey& side) {
    const std::uint32_t mixed = (std::uint32_t(side.x) * 73856093u ^ std::uint32_t(side.y) * 19349663u ^
                                 std::uint32_t(side.horizontal) * 83492791u) >>
                                3;
    const float detail = float(mixed % 1000) / 999.0f * float(layout.topIndex(side.level));
    return whole ? std::round(detail) : detail;
  };
}

inline std::shared_ptr<const TeHeightMap> hillyMap(int resolution, float height = 40, float mean = 0) {
  auto map = TeHeightMap::create(resolution + 1, resolution + 1);
  EXPECT_TRUE(map);
  for (int y = 0; y <= resolution; y++)
    for (int x = 0; x <= resolution; x++) {
      const double u = double(x) / resolution, v = double(y) / resolution;
      map->at(x, y) =
          mean + float(height * (std::sin(9 * u) * std::cos(7 * v) + 0.3 * std::sin(31 * u + 17 * v) +
                                 0.1 * std::sin(140 * u) * std::cos(120 * v)));
    }
  return std::make_shared<const TeHeightMap>(std::move(*map));
}

inline glm::dmat4 doubles(const SbMatrix& matrix) {
  glm::dmat4 result;
  for (int row = 0; row < 4; row++)
    for (int column = 0; column < 4; column++)
      result[row][column] = double(matrix[row][column]); // row vectors there, column vectors here
  return result;
}

/// A terrain in a Coin scene, drawn by what Coin's state says.
struct SeamlessScene {
  SeamlessScene(const TeSeamlessLayout& sizes, int level, bool wholePatches = false)
      : layout(sizes), parts(std::make_shared<TeSeamlessParts>(sizes, wholePatches)),
        drawing(std::make_unique<TeSeamlessDrawing>(sizes, parts)) {
    select(selectLevel(layout, level));
    placement.corner = {-0.5 * layout.resolution(), -0.5 * layout.resolution(), 0};
    node = TeNodePtr<SoCallback>(new SoCallback);
    node->setCallback(
        [](void* self, SoAction* action) {
          if (action->isOfType(SoGLRenderAction::getClassTypeId()))
            static_cast<SeamlessScene*>(self)->render(action->getState());
        },
        this);
  }
  void select(const TeSeamlessSelection& chosen) {
    selection = chosen;
    lists.build(selection, layout, *parts);
  }
  /// As an eye near the middle of the terrain needs it.
  void selectAround(float precision, bool geomorph, const TeClipResidency* residency = nullptr) {
    TeLodView view;
    view.eye = placement.corner + glm::dvec3(0.45, 0.55, 0.05) * double(layout.resolution());
    TeSeamlessAccuracy accuracy;
    accuracy.precision = precision;
    accuracy.geomorph = geomorph;
    TeSeamlessSelector(layout, nullptr).select(view, placement, accuracy, residency, selection);
    select(TeSeamlessSelection(selection));
  }

  void render(SoState* state) {
    const SbMatrix model = SoModelMatrixElement::get(state);
    const SbMatrix view = SoViewingMatrixElement::get(state);
    TeSeamlessFrame frame(placement, doubles(view) * doubles(model),
                          doubles(SoProjectionMatrixElement::get(state)));
    frame.heightClipmap = heightClipmap;
    frame.colourClipmap = colourClipmap;
    SoGLLazyElement::getInstance(state)->send(state, SoLazyElement::ALL_MASK);
    const std::uint32_t context = std::uint32_t(SoGLCacheContextElement::get(state));
    if (captures) {
      EXPECT_TRUE(drawing->draw(context, lists, look, frame));
      auto vertices = drawing->renderer(context)->capture(lists, look, frame);
      EXPECT_TRUE(vertices) << (vertices ? "" : vertices.error().message);
      captured = std::move(*vertices);
      drawnFrame = std::make_unique<TeSeamlessFrame>(frame);
      return;
    }
    const auto drawn = drawing->draw(context, lists, look, frame);
    error = drawn ? "" : drawn.error().message;
    counts = drawn ? *drawn : TeSeamlessCounts{};
  }

  TeSeamlessLayout layout;
  std::shared_ptr<TeSeamlessParts> parts;
  std::unique_ptr<TeSeamlessDrawing> drawing;
  TeSeamlessSelection selection;
  TeSeamlessLists lists;
  TeSeamlessLook look;
  TeSeamlessPlacement placement;
  TeNodePtr<SoCallback> node;
  const TeSeamlessClipTexture* heightClipmap = nullptr;
  const TeSeamlessClipTexture* colourClipmap = nullptr;
  bool captures = false;
  std::vector<TeSeamlessRenderer::DrawnVertex> captured;
  std::unique_ptr<TeSeamlessFrame> drawnFrame;
  std::string error;
  TeSeamlessCounts counts;
};
