#include "worker/stage/envelope.h"

#include <cstdint>
#include <cstring>

#include "digest/sha256.h"
#include "vocab/stage.h"

namespace regolab {
namespace {

constexpr std::string_view kMagic = "REGOLAB1";
constexpr std::size_t kDigest = 64;              // hex digits
constexpr std::size_t kHeader = 8 + 4 + 4 + 8;  // magic, content, physics version, length of the stage text

template <class T>
void append(std::string& bytes, T value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }

template <class T>
T read_at(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

Error damaged(const char* why) {
  return {Code::kDataLoss, std::string("unusable bed or checkpoint (") + why + ") run the stage again from its start"};
}

}  // namespace

std::string seal(Content content, std::string_view stage_text, std::string_view payload) {
  std::string bytes(kMagic);
  append(bytes, static_cast<std::int32_t>(content));
  append(bytes, static_cast<std::int32_t>(kPhysicsVersion));
  append(bytes, static_cast<std::uint64_t>(stage_text.size()));
  bytes += stage_text;
  bytes += payload;
  return bytes + sha256_hex(bytes);
}

Result<std::string_view> unseal(Content content, std::string_view stage_text, std::string_view bytes) {
  if (bytes.size() < kHeader + kDigest || bytes.substr(0, kMagic.size()) != kMagic) return damaged("not one of ours");
  const std::string_view body = bytes.substr(0, bytes.size() - kDigest);
  if (sha256_hex(body) != bytes.substr(body.size())) return damaged("its checksum is wrong");
  if (read_at<std::int32_t>(body, 8) != static_cast<std::int32_t>(content)) return damaged("a bed for a checkpoint or the reverse");
  if (read_at<std::int32_t>(body, 12) != kPhysicsVersion) return damaged("made by another physics version");
  const auto length = read_at<std::uint64_t>(body, 16);
  if (length > body.size() - kHeader) return damaged("its header is wrong");
  if (!stage_text.empty() && body.substr(kHeader, length) != stage_text) return damaged("it belongs to another stage");
  return body.substr(kHeader + length);
}

}  // namespace regolab
