#pragma once

#include "patchdb/TeSourceMap.h"

#include <mutex>
#include <unordered_map>

/// The source maps in memory, which take themselves out when their last pointer goes. Thread-safe.
class TeResidentMaps {
public:
  TeSourceMapPtr find(TeMapKey key) const;
  /// Takes ownership of a new map under its key. `self` is this, shared: maps may outlive the rest.
  static TeSourceMapPtr add(const std::shared_ptr<TeResidentMaps>& self, TeSourceMap map);
  std::size_t size() const;
  std::size_t bytes() const;

private:
  struct KeyHash {
    std::size_t operator()(const TeMapKey& key) const;
  };
  struct Entry {
    const TeSourceMap* address = nullptr;
    std::weak_ptr<const TeSourceMap> map;
  };
  void remove(const TeSourceMap& map);

  mutable std::mutex m_mutex;
  std::unordered_map<TeMapKey, Entry, KeyHash> m_maps;
  std::size_t m_bytes = 0;
};
