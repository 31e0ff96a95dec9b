#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/lod/drawing/TeLodSender.h"

#include <Inventor/nodes/SoCallback.h>

#include <memory>
#include <vector>

/// Some parts of a mesh, sent in one of document 003's ways whenever its node is drawn in the current
/// context: as they are, or changed everywhere for each frame. What a terrain node does besides, it does not
/// do.
class TeSubmissionShape {
public:
  /// `parts` must outlive it. Positions are the node's coordinates.
  TeSubmissionShape(const std::vector<TeLodArrays>& parts, TeLodSubmission way, bool changes);
  /// In the context that it was drawn in, which is current.
  ~TeSubmissionShape();
  TeSubmissionShape(const TeSubmissionShape&) = delete;
  TeSubmissionShape& operator=(const TeSubmissionShape&) = delete;

  /// Moves every vertex a little, if data is to change: before each frame.
  void change();
  SoNode* node() const { return m_node.get(); }
  bool isUsable() const { return m_isUsable; }
  /// Of the last frame: bytes that OpenGL was given, draw calls.
  std::int64_t bytesSent() const { return m_bytes; }
  std::int64_t drawCalls() const { return m_calls; }
  /// Of the copy that is sent: vertices and indices.
  std::size_t bytes() const;

private:
  static void onDraw(void* shape, SoAction* action);
  void draw(std::uint32_t context);
  void freeKept();

  TeNodePtr<SoCallback> m_node;
  std::vector<TeLodArrays> m_parts; ///< as the way needs them
  TeLodSubmission m_way;
  bool m_changes;
  bool m_isUsable = true;
  TeLodGl m_gl;
  std::unique_ptr<TeLodSender> m_sender; ///< once there is a context
  std::vector<TeLodSender::Kept> m_kept;
  int m_frame = 0;
  std::int64_t m_bytes = 0;
  std::int64_t m_calls = 0;
};
