#include "nodes/seamless/TeSeamlessViewer.h"

TeStatus TeSeamlessViewer::follow(const TeSeamlessScene& scene, std::uint32_t context, const glm::dvec3& eye,
                                  bool inBudget) {
  const TeSeamlessLayout& layout = scene.content.terrain->layout;
  const double side = scene.placement.spacing * layout.resolution();
  const glm::dvec2 centre = glm::dvec2(eye - scene.placement.corner) / side;
  if (scene.content.clipmap && !heights) {
    TeResult<std::shared_ptr<TeSeamlessClip>> made =
        TeSeamlessClip::create(scene.content.clipmap.get(), context, layout.resolutionLog());
    if (!made)
      return made.error();
    heights = std::move(*made);
  }
  if (scene.colours && !colours) {
    TeResult<std::shared_ptr<TeSeamlessClip>> made = TeSeamlessClip::create(scene.colours.get(), context);
    if (!made)
      return made.error();
    colours = std::move(*made);
  }
  if (heights)
    heights->follow(centre, inBudget);
  if (colours)
    colours->follow(centre, inBudget);
  return {};
}

TeStatus TeSeamlessViewer::upload() {
  if (heights) {
    if (TeStatus status = heights->upload(); !status)
      return status;
  }
  return colours ? colours->upload() : TeStatus();
}

bool TeSeamlessViewer::isSettled() const {
  return (!heights || heights->isSettled()) && (!colours || colours->isSettled());
}

std::int64_t TeSeamlessViewer::bytesUploaded() const {
  return (heights ? heights->bytesUploaded() : 0) + (colours ? colours->bytesUploaded() : 0);
}

void TeSeamlessViewer::release(bool isCurrent) {
  for (const std::shared_ptr<TeSeamlessClip>& clip : {heights, colours}) {
    if (clip && isCurrent)
      clip->free();
    else if (clip)
      TeSeamlessClip::release(clip);
  }
  heights.reset();
  colours.reset();
}
