#pragma once

#include <cstdint>
#include <functional>
#include <utility>

/// Finds the OpenGL functions of a table by their names.
class TeGlLoader {
public:
  using Lookup = std::function<void*(const char* name)>; ///< null: there is none

  explicit TeGlLoader(Lookup procAddress) : m_procAddress(std::move(procAddress)) {}
  /// Of the current context, by the number under which Coin knows it.
  explicit TeGlLoader(std::uint32_t context);

  /// False, and null: there is none.
  template <class Function> bool find(const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(m_procAddress(name));
    return function != nullptr;
  }
  template <class Function> void need(const char* name, Function*& function) {
    if (!find(name, function) && !m_missing)
      m_missing = name;
  }
  /// The first one that was needed and is not there; null: none.
  const char* missing() const { return m_missing; }
  /// True if none is missing; otherwise the log is told so, and `consequence`: what does not happen.
  bool isComplete(const char* consequence) const;

private:
  Lookup m_procAddress;
  const char* m_missing = nullptr;
};
