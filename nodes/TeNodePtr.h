#pragma once

#include <utility>

/// Holds a reference to a Coin object for as long as it lives. Not thread-safe, as Coin's counts are not.
template <class T> class TeNodePtr {
public:
  TeNodePtr(T* object = nullptr) : m_object(object) {
    if (m_object)
      m_object->ref();
  }
  TeNodePtr(const TeNodePtr& other) : TeNodePtr(other.m_object) {}
  TeNodePtr(TeNodePtr&& other) noexcept : m_object(std::exchange(other.m_object, nullptr)) {}
  TeNodePtr& operator=(TeNodePtr other) noexcept {
    std::swap(m_object, other.m_object);
    return *this;
  }
  ~TeNodePtr() {
    if (m_object)
      m_object->unref();
  }

  T* get() const { return m_object; }
  T* operator->() const { return m_object; }
  T& operator*() const { return *m_object; }
  explicit operator bool() const { return m_object != nullptr; }

private:
  T* m_object;
};
