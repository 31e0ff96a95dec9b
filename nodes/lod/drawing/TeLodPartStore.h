#pragma once

#include "nodes/lod/drawing/TeLodSender.h"

#include <cstdint>
#include <unordered_map>

/// Parts that a viewer keeps from frame to frame, by their keys (TeLodPart). As much memory as `limit` says:
/// those that were not drawn for longest make room.
class TeLodPartStore {
public:
  static constexpr std::size_t kMostBytes = std::size_t(256) << 20;

  explicit TeLodPartStore(TeLodSender& sender, std::size_t limit = kMostBytes)
      : m_sender(sender), m_limit(limit) {}

  /// Parts that find() or add() gives from now on belong to a new frame, and stay while it lasts.
  void beginFrame() { m_frame++; }
  /// Null if it is not there.
  const TeLodSender::Kept* find(std::uint64_t key);
  /// Keeps a part that is not there. Null, with the arrays as they were: it has no room beside this frame's.
  const TeLodSender::Kept* add(std::uint64_t key, TeLodArrays& arrays);
  void clear();

  std::size_t size() const { return m_parts.size(); }
  std::size_t bytes() const { return m_bytes; }

private:
  struct Entry {
    TeLodSender::Kept part;
    std::uint64_t frame = 0;
  };
  void makeRoom(std::size_t bytes);

  TeLodSender& m_sender;
  std::size_t m_limit;
  std::unordered_map<std::uint64_t, Entry> m_parts;
  std::size_t m_bytes = 0;
  std::uint64_t m_frame = 0;
};
