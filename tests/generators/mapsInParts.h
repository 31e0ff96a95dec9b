#pragma once

#include "generators/TeHeightSource.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

/// In slices of so many units, at least two, the map has the bits of `whole`.
inline void expectMapInSlices(const TeHeightSource& source, const TeMapRequest& request, std::int64_t units,
                              const TeHeightMap& whole) {
  const std::unique_ptr<TeHeightJob> job = source.start(request);
  int slices = 0;
  for (TeProgress progress = TeProgress::Working; progress == TeProgress::Working; ++slices) {
    TeAllowance allowance = TeAllowance::units(units);
    progress = job->step(allowance);
    ASSERT_NE(progress, TeProgress::Failed) << job->error().message;
  }
  EXPECT_GT(slices, 1);
  EXPECT_EQ(job->takeMap(), whole) << "slices of " << units;
}

/// Every `stride`-th sample, the last row first, has the bits of the map. Few samples are evaluated each by
/// itself, many by way of the map.
inline void expectSamplesOfMap(const TeHeightSource& source, const TeMapRequest& request, int stride) {
  ASSERT_TRUE(source.pointEvaluable());
  const TeHeightMap map = *source.generate(request);
  std::vector<TeMapSample> samples;
  for (int r = request.rows - 1; r >= 0; r -= stride)
    for (int c = 0; c < request.columns; c += stride)
      samples.push_back({c, r});
  std::vector<float> heights(samples.size());
  ASSERT_TRUE(source.evaluate(request, samples.data(), samples.size(), heights.data()));
  for (std::size_t i = 0; i < samples.size(); ++i)
    EXPECT_EQ(heights[i], map.at(samples[i].column, samples[i].row));
}
