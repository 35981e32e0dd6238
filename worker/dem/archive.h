/// Binary save and load of plain state, for beds and checkpoints. One `archive(ar)` member per type serves both ways.
#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace regolab::dem {

/// Numbers only: a struct's padding would make equal states differ in their bytes.
template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class Saver {
 public:
  static constexpr bool kLoading = false;
  template <class... T>
  void operator()(T&... fields) { (put(fields), ...); }
  std::string take() { return std::move(bytes_); }

 private:
  template <Plain T>
  void put(T& value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  template <Plain T>
  void put(std::vector<T>& values) {
    std::uint64_t n = values.size();
    put(n);
    bytes_.append(reinterpret_cast<const char*>(values.data()), n * sizeof(T));
  }
  template <class T, std::size_t N>
  void put(std::array<T, N>& values) { for (T& value : values) put(value); }
  void put(std::string& text) {
    std::uint64_t n = text.size();
    put(n);
    bytes_ += text;
  }
  template <class T>
    requires requires(T& t, Saver& s) { t.archive(s); }
  void put(T& part) { part.archive(*this); }
  template <class T>
    requires requires(T& t, Saver& s) { t.archive(s); }
  void put(std::vector<T>& parts) {
    std::uint64_t n = parts.size();
    put(n);
    for (T& part : parts) part.archive(*this);
  }

  std::string bytes_;
};

/// Reading past the end or absurd lengths set failed(); fields keep what they had.
class Loader {
 public:
  static constexpr bool kLoading = true;
  explicit Loader(std::string_view bytes) : bytes_(bytes) {}
  template <class... T>
  void operator()(T&... fields) { (get(fields), ...); }
  bool failed() const { return failed_; }
  bool finished() const { return !failed_ && bytes_.empty(); }

 private:
  bool read(void* to, std::uint64_t n) {
    if (failed_ || n > bytes_.size()) {
      failed_ = true;
      return false;
    }
    if (n > 0) std::memcpy(to, bytes_.data(), n);
    bytes_.remove_prefix(n);
    return true;
  }
  std::uint64_t length(std::uint64_t item_size) {
    std::uint64_t n = 0;
    read(&n, sizeof n);
    if (n > bytes_.size() / item_size) failed_ = true;
    return failed_ ? 0 : n;
  }
  template <Plain T>
  void get(T& value) {
    T read_value;
    if (read(&read_value, sizeof read_value)) value = read_value;
  }
  template <Plain T>
  void get(std::vector<T>& values) {
    values.resize(length(sizeof(T)));
    read(values.data(), values.size() * sizeof(T));
  }
  template <class T, std::size_t N>
  void get(std::array<T, N>& values) { for (T& value : values) get(value); }
  void get(std::string& text) {
    text.resize(length(1));
    read(text.data(), text.size());
  }
  template <class T>
    requires requires(T& t, Loader& l) { t.archive(l); }
  void get(T& part) { part.archive(*this); }
  template <class T>
    requires requires(T& t, Loader& l) { t.archive(l); }
  void get(std::vector<T>& parts) {
    parts.resize(length(1));
    for (T& part : parts) {
      if (!failed_) part.archive(*this);
    }
  }

  std::string_view bytes_;
  bool failed_ = false;
};

}  // namespace regolab::dem
