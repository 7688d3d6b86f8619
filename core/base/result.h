// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/assert.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace esm {

/// What kind of fault of the world it was; the window translates by this, `detail` stays English.
enum class ErrorCode {
  FileUnreadable, ///< absent, a folder, no permission
  FileUnwritable, ///< no permission, disk full
  BadFormat,      ///< the bytes are not what the format promises
  Unsupported,    ///< a format or feature that this build does not know
  NewerVersion,   ///< written by a later program
  InvalidValue,   ///< a number or name outside its range
  EmptyResult,    ///< read well, but nothing of use in it
  Numerics,       ///< the computation could not be carried out
  NoDevice,       ///< device absent, busy or not permitted
  OutOfMemory,    ///< the allocator gave up
  Cancelled,
  Internal
};

/// One clear sentence for one fault: which file, where, what, the way out. No line break, no full stop.
struct Error {
  ErrorCode code = ErrorCode::Internal;
  std::string detail;
};

/// An error about a number or name outside its range.
inline Error invalidValue(std::string detail)
{
  return {ErrorCode::InvalidValue, std::move(detail)};
}

/// A value, or the Error that came in its place. Shaped like std::expected, to be swapped in later.
template <class T>
class [[nodiscard]] Result {
public:
  Result(T value) : m_content(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : m_content(std::in_place_index<1>, std::move(error)) {}

  bool hasValue() const noexcept { return m_content.index() == 0; }
  explicit operator bool() const noexcept { return hasValue(); }

  /// @pre hasValue()
  T& value() &
  {
    ESM_ASSERT(hasValue());
    return *std::get_if<0>(&m_content);
  }
  const T& value() const&
  {
    ESM_ASSERT(hasValue());
    return *std::get_if<0>(&m_content);
  }
  T&& value() &&
  {
    ESM_ASSERT(hasValue());
    return std::move(*std::get_if<0>(&m_content));
  }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// @pre !hasValue()
  const Error& error() const
  {
    ESM_ASSERT(!hasValue());
    return *std::get_if<1>(&m_content);
  }

private:
  std::variant<T, Error> m_content;
};

/// Done, or the Error that prevented it.
template <>
class [[nodiscard]] Result<void> {
public:
  Result() = default;
  Result(Error error) : m_error(std::move(error)) {}

  bool hasValue() const noexcept { return !m_error.has_value(); }
  explicit operator bool() const noexcept { return hasValue(); }
  const Error& error() const
  {
    ESM_ASSERT(!hasValue());
    return *m_error;
  }

private:
  std::optional<Error> m_error;
};

using Status = Result<void>;

} // namespace esm
