// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace slipstitch {

/// A value, or why there is none: `error` names the file and the reason, and is empty exactly when there is a value.
template <class T>
struct Result {
  std::optional<T> value;
  std::string error;

  explicit operator bool() const { return value.has_value(); }
  T& operator*() { return *value; }
  const T& operator*() const { return *value; }
  T* operator->() { return &*value; }
  const T* operator->() const { return &*value; }

  static Result of(T result) { return {std::move(result), {}}; }
  static Result failed(std::string why) { return {std::nullopt, std::move(why)}; }
};

/// Empty: done. Otherwise what went wrong, naming the file.
using IoError = std::string;

}  // namespace slipstitch
