/// Reads the .vtp files that worker/output writes, by the offsets their XML states, as ParaView would.
#pragma once
#include <cstdint>
#include <cstring>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace regolab::test {

class VtpFile {
 public:
  explicit VtpFile(std::string text) : text_(std::move(text)) {
    block_ = text_.find("<AppendedData encoding=\"raw\">");
    block_ = text_.find('_', block_) + 1;
  }

  long count(const std::string& attribute) const { return std::stol(attribute_of(text_.substr(0, block_), attribute)); }

  /// The values of the array with this name and type ("Float64", "Int32", "Int64").
  template <class T>
  std::vector<T> array(const std::string& name, const std::string& type) const {
    const std::string tag = tag_of(name);
    if (attribute_of(tag, "type") != type) throw std::runtime_error(name + " is not " + type);
    const std::size_t at = block_ + std::stoul(attribute_of(tag, "offset"));
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, text_.data() + at, sizeof bytes);
    if (at + sizeof bytes + bytes > text_.size()) throw std::runtime_error(name + " runs past the end");
    std::vector<T> values(bytes / sizeof(T));
    std::memcpy(values.data(), text_.data() + at + sizeof bytes, bytes);
    return values;
  }

 private:
  static std::string attribute_of(const std::string& xml, const std::string& name) {
    std::smatch match;
    if (!std::regex_search(xml, match, std::regex(name + "=\"([^\"]*)\""))) throw std::runtime_error("no " + name);
    return match[1];
  }
  std::string tag_of(const std::string& name) const {
    const std::string head = text_.substr(0, block_);
    std::smatch match;
    if (!std::regex_search(head, match, std::regex("<DataArray[^>]*Name=\"" + name + "\"[^>]*>")))
      throw std::runtime_error("no " + name);
    return match[0];
  }

  std::string text_;
  std::size_t block_ = 0;  ///< where the appended data begin
};

}  // namespace regolab::test
