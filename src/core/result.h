// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/check.h"

namespace yorb {

/// What went wrong, in one line that names the file, the line and the remedy.
struct Error {
  enum class Kind {
    kBadInput,  ///< a file, a flag, a calibration from outside is wrong: exit code 2
    kFailure,   ///< the machine or we failed (disk full, cannot write): exit code 1
  };
  Kind kind = Kind::kBadInput;
  std::string message;
};

/// An error that the user can mend.
inline Error BadInput(std::string message) { return {Error::Kind::kBadInput, std::move(message)}; }

/// An error of the machine, or of ours.
inline Error Failure(std::string message) { return {Error::Kind::kFailure, std::move(message)}; }

/// The error that an exception of the machine or of a library stands for.
inline Error FailureOf(const std::exception& error) {
  const bool is_memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  return Failure(is_memory ? "there is not enough memory" : std::string("internal failure: ") + error.what());
}

/// A value, or the reason why there is none.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT(google-explicit-constructor): `return value;` reads well
  Result(Error error) : state_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return std::holds_alternative<T>(state_); }
  explicit operator bool() const { return ok(); }

  const T& value() const& { return Get(); }
  T& value() & { return const_cast<T&>(std::as_const(*this).Get()); }
  T&& value() && { return std::move(const_cast<T&>(std::as_const(*this).Get())); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  const Error& error() const {
    YORB_CHECK(!ok(), "error() of a Result that holds a value");
    return std::get<Error>(state_);
  }

 private:
  const T& Get() const {
    YORB_CHECK(ok(), std::get<Error>(state_).message.c_str());
    return std::get<T>(state_);
  }

  std::variant<T, Error> state_;
};

/// Done, or the reason why not.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  static Status Ok() { return {}; }
  bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }
  const Error& error() const {
    YORB_CHECK(!ok(), "error() of a Status that is fine");
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace yorb
