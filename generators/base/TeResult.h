#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

/// Why something could not be done: one line that names the file or argument, the place and the reason.
struct TeError {
  std::string message;
};

/// A value or the error that kept it from being made. Nothing in Terrane throws across a layer.
template <class T> class [[nodiscard]] TeResult {
public:
  TeResult(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
  TeResult(TeError error) : m_state(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return m_state.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// The value; only if ok().
  T& value() & {
    assert(ok());
    return std::get<0>(m_state);
  }
  const T& value() const& {
    assert(ok());
    return std::get<0>(m_state);
  }
  T&& value() && {
    assert(ok());
    return std::get<0>(std::move(m_state));
  }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// The error; only if not ok().
  const TeError& error() const {
    assert(!ok());
    return std::get<1>(m_state);
  }

private:
  std::variant<T, TeError> m_state;
};

/// Success, or an error: the result of work that returns nothing.
class [[nodiscard]] TeStatus {
public:
  TeStatus() = default;
  TeStatus(TeError error) : m_error(std::move(error)), m_ok(false) {}

  bool ok() const { return m_ok; }
  explicit operator bool() const { return m_ok; }
  const TeError& error() const {
    assert(!m_ok);
    return m_error;
  }

private:
  TeError m_error;
  bool m_ok = true;
};
