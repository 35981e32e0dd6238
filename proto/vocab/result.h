/// The error ladder's third rung: what may fail in normal life returns Result<T> (shaped like std::expected).
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace regolab {

/// gRPC's code names, so that a handler translates one to one.
enum class Code {
  kInvalidArgument,
  kNotFound,
  kAlreadyExists,
  kFailedPrecondition,
  kResourceExhausted,
  kAborted,
  kUnavailable,
  kDataLoss,
  kCancelled,
  kInternal,
};

/// Text reads *problem (why) remedy*.
struct Error {
  Code code = Code::kInternal;
  std::string text;
};

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : held_(std::in_place_index<0>, std::move(value)) {}        // NOLINT: implicit like std::expected
  Result(Error error) : held_(std::in_place_index<1>, std::move(error)) {}    // NOLINT

  bool ok() const { return held_.index() == 0; }
  explicit operator bool() const { return ok(); }
  T& value() & { return std::get<0>(held_); }
  const T& value() const& { return std::get<0>(held_); }
  T&& value() && { return std::get<0>(std::move(held_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const { return std::get<1>(held_); }

 private:
  std::variant<T, Error> held_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT

  bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  const Error& error() const { return *error_; }

 private:
  std::optional<Error> error_;
};

inline Error invalid(std::string text) { return {Code::kInvalidArgument, std::move(text)}; }

}  // namespace regolab
