#include "nodes/terrain/TeMeshDrawing.h"

#include "generators/base/TeAllowance.h"

#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace {

constexpr double kFading = 0.9; ///< of what was measured, per frame with uploads

} // namespace

TeMeshDrawing::TeMeshDrawing(glm::dvec2 anchor) : m_translation(new SoTranslation), m_anchor(anchor) {
  assert(std::isfinite(anchor.x) && std::isfinite(anchor.y));
  updateTranslation();
  SoContextHandler::addContextDestructionCallback(&TeMeshDrawing::onContextDestroyed, this);
}

TeMeshDrawing::~TeMeshDrawing() {
  SoContextHandler::removeContextDestructionCallback(&TeMeshDrawing::onContextDestroyed, this);
  for (const auto& [context, buffers] : m_buffers) {
    if (buffers->retireAll())
      freeWhenCurrent(buffers);
  }
}

void TeMeshDrawing::setWorldOrigin(glm::dvec3 origin) {
  m_worldOrigin = origin;
  updateTranslation();
}

void TeMeshDrawing::updateTranslation() {
  const SbVec3f offset(float(m_anchor.x - m_worldOrigin.x), float(m_anchor.y - m_worldOrigin.y),
                       float(-m_worldOrigin.z));
  if (m_translation->translation.getValue() != offset)
    m_translation->translation = offset;
}

void TeMeshDrawing::setAnchor(glm::dvec2 anchor) {
  assert(std::isfinite(anchor.x) && std::isfinite(anchor.y));
  m_anchor = anchor;
  m_changes = false;
  updateTranslation();
}

void TeMeshDrawing::beginAnchor(glm::dvec2 next) {
  assert(std::isfinite(next.x) && std::isfinite(next.y));
  m_nextAnchor = next;
  m_changes = true;
  m_wasReady = false;
  m_withNext = 0;
  m_withoutNext = 0;
}

bool TeMeshDrawing::nextAnchorReady() const {
  if (!m_changes)
    return false;
  const bool hasDrawn = m_withNext + m_withoutNext > 0;
  return hasDrawn ? m_withoutNext == 0 : m_wasReady;
}

void TeMeshDrawing::commitAnchor() {
  assert(m_changes);
  setAnchor(m_nextAnchor);
}

void TeMeshDrawing::setPixelError(double pixels) {
  assert(pixels >= 0 && std::isfinite(pixels));
  m_pixelError = pixels;
}

std::shared_ptr<const TeGridLevels> TeMeshDrawing::gridLevels(int columns, int rows) {
  std::shared_ptr<const TeGridLevels>& levels = m_levels[{columns, rows}];
  if (!levels)
    levels = std::make_shared<const TeGridLevels>(columns, rows);
  return levels;
}

bool TeMeshDrawing::mayFindErrors(std::size_t vertices) {
  // At least one mesh, however large.
  if (m_errorVerticesLeft < kErrorVertices && vertices > m_errorVerticesLeft)
    return false;
  m_errorVerticesLeft -= std::min(vertices, m_errorVerticesLeft);
  return true;
}

void TeMeshDrawing::resetFrame(std::size_t anchorBytes) {
  m_wasReady = nextAnchorReady();
  m_withNext = 0;
  m_withoutNext = 0;
  m_anchorBytesLeft = anchorBytes;
  m_freesLeft = kFreedPerFrame;
  m_errorVerticesLeft = kErrorVertices;
  if (m_frame.bytesUploaded > 0) {
    m_recentSeconds = kFading * m_recentSeconds + m_frame.uploadSeconds;
    m_recentBytes = kFading * m_recentBytes + double(m_frame.bytesUploaded);
    m_recentUploads = kFading * m_recentUploads + double(m_frame.uploads);
    m_secondsPerByte = m_recentSeconds / m_recentBytes;
    m_secondsPerUpload = std::max(0.0, (m_recentSeconds - kCopySeconds * m_recentBytes) / m_recentUploads);
  }
  m_frame = {};
}

std::size_t TeMeshDrawing::bufferBytes() const {
  std::size_t bytes = 0;
  for (const auto& [context, buffers] : m_buffers)
    bytes += buffers->bytes();
  return bytes;
}

TeMeshBuffers& TeMeshDrawing::buffers(std::uint32_t context) {
  std::shared_ptr<TeMeshBuffers>& buffers = m_buffers[context];
  if (!buffers)
    buffers = std::make_shared<TeMeshBuffers>(context);
  return *buffers;
}

TeMeshBuffers::Mesh* TeMeshDrawing::prepare(TeMeshBuffers& buffers, const void* node, const TePatchMesh& mesh,
                                            const std::vector<std::uint32_t>& colours) {
  if (!buffers.isUsable())
    return nullptr;
  TeMeshBuffers::Mesh* made = buffers.find(node);
  if (!made) {
    const double start = teThreadCpuSeconds();
    const std::size_t before = buffers.bytes();
    made = &buffers.add(node, mesh, colours, m_anchor);
    count(buffers.bytes() - before, start);
  }
  if (made->anchor != m_anchor) {
    if (made->nextPositions && made->nextAnchor == m_anchor) {
      buffers.useNextAnchor(*made);
    } else {
      const double start = teThreadCpuSeconds();
      buffers.setAnchor(*made, mesh, m_anchor);
      count(TeMeshBuffers::positionBytes(mesh), start);
    }
  }
  if (m_changes) {
    prepareNextAnchor(buffers, *made, mesh);
  } else if (made->nextPositions && m_freesLeft > 0) {
    buffers.dropNextAnchor(*made);
    m_freesLeft--;
  }
  return made;
}

void TeMeshDrawing::prepareLevel(TeMeshBuffers& buffers, const TeMeshBuffers::Mesh& made,
                                 const TeGridLevels& levels, int level) {
  if (buffers.hasLevel(made, level))
    return;
  const double start = teThreadCpuSeconds();
  count(buffers.addLevel(made, levels, level), start);
}

void TeMeshDrawing::prepareNextAnchor(TeMeshBuffers& buffers, TeMeshBuffers::Mesh& made,
                                      const TePatchMesh& mesh) {
  const bool isThere = made.nextPositions && made.nextAnchor == m_nextAnchor;
  if (!isThere && m_anchorBytesLeft > 0) {
    const std::size_t bytes = TeMeshBuffers::positionBytes(mesh);
    const double start = teThreadCpuSeconds();
    buffers.setNextAnchor(made, mesh, m_nextAnchor);
    count(bytes, start);
    m_anchorBytesLeft -= std::min(bytes, m_anchorBytesLeft);
  } else if (!isThere) {
    m_withoutNext++;
    return;
  }
  m_withNext++;
}

void TeMeshDrawing::count(std::size_t bytes, double start) {
  m_frame.uploads++;
  m_frame.bytesUploaded += std::int64_t(bytes);
  m_frame.uploadSeconds += teThreadCpuSeconds() - start;
}

void TeMeshDrawing::forget(const void* node) {
  for (const auto& [context, buffers] : m_buffers) {
    if (buffers->retire(node))
      freeWhenCurrent(buffers);
  }
}

void TeMeshDrawing::freeWhenCurrent(const std::shared_ptr<TeMeshBuffers>& buffers) {
  SoGLCacheContextElement::scheduleDeleteCallback(
      buffers->context(),
      [](void* closure, std::uint32_t) {
        const std::unique_ptr<std::shared_ptr<TeMeshBuffers>> held(
            static_cast<std::shared_ptr<TeMeshBuffers>*>(closure));
        (*held)->freeRetired();
      },
      new std::shared_ptr<TeMeshBuffers>(buffers));
}

void TeMeshDrawing::onContextDestroyed(std::uint32_t context, void* drawing) {
  auto& all = static_cast<TeMeshDrawing*>(drawing)->m_buffers;
  const auto found = all.find(context);
  if (found == all.end())
    return;
  found->second->retireAll();
  found->second->freeRetired();
  all.erase(found);
}
