#include "seal/seal.h"

#include <openssl/evp.h>

#include <memory>

#include "seal/random_bytes.h"

namespace regolab {
namespace {

constexpr std::size_t kNonce = 12, kTag = 16;  // [bytes] what GCM is specified for

using Context = std::unique_ptr<EVP_CIPHER_CTX, decltype(&EVP_CIPHER_CTX_free)>;
Context new_context() { return {EVP_CIPHER_CTX_new(), &EVP_CIPHER_CTX_free}; }

const unsigned char* bytes(std::string_view text) { return reinterpret_cast<const unsigned char*>(text.data()); }
unsigned char* bytes(std::string& text) { return reinterpret_cast<unsigned char*>(text.data()); }

Error broken() { return {Code::kInternal, "the cipher failed (OpenSSL refused AES-256-GCM) use another build of OpenSSL"}; }
Error not_ours() { return {Code::kDataLoss, "the seal does not open (another key, another name, or changed bytes) take the key of this set"}; }

}  // namespace

Result<std::string> sealed(std::string_view key, std::string_view text, std::string_view name) {
  if (key.size() != kKeyBytes)
    return invalid("the key has " + std::to_string(key.size()) + " bytes (AES-256 takes 32) take a key that was made for a set");
  auto nonce = random_bytes(kNonce);
  if (!nonce.ok()) return nonce.error();
  const Context context = new_context();
  std::string out(text.size(), '\0'), tag(kTag, '\0');
  int n = 0;
  const bool ok = context && EVP_EncryptInit_ex(context.get(), EVP_aes_256_gcm(), nullptr, bytes(key), bytes(*nonce)) == 1 &&
                  EVP_EncryptUpdate(context.get(), nullptr, &n, bytes(name), static_cast<int>(name.size())) == 1 &&
                  EVP_EncryptUpdate(context.get(), bytes(out), &n, bytes(text), static_cast<int>(text.size())) == 1 &&
                  EVP_EncryptFinal_ex(context.get(), bytes(out) + n, &n) == 1 &&
                  EVP_CIPHER_CTX_ctrl(context.get(), EVP_CTRL_GCM_GET_TAG, kTag, tag.data()) == 1;
  if (!ok) return broken();
  return *nonce + out + tag;
}

Result<std::string> opened(std::string_view key, std::string_view from, std::string_view name) {
  if (key.size() != kKeyBytes || from.size() < kNonce + kTag) return not_ours();
  const std::string_view nonce = from.substr(0, kNonce), text = from.substr(kNonce, from.size() - kNonce - kTag);
  std::string tag(from.substr(from.size() - kTag)), out(text.size(), '\0');
  const Context context = new_context();
  int n = 0;
  const bool ready = context && EVP_DecryptInit_ex(context.get(), EVP_aes_256_gcm(), nullptr, bytes(key), bytes(nonce)) == 1 &&
                     EVP_DecryptUpdate(context.get(), nullptr, &n, bytes(name), static_cast<int>(name.size())) == 1 &&
                     EVP_DecryptUpdate(context.get(), bytes(out), &n, bytes(text), static_cast<int>(text.size())) == 1 &&
                     EVP_CIPHER_CTX_ctrl(context.get(), EVP_CTRL_GCM_SET_TAG, kTag, tag.data()) == 1;
  if (!ready) return broken();
  if (EVP_DecryptFinal_ex(context.get(), bytes(out) + n, &n) != 1) return not_ours();
  return out;
}

}  // namespace regolab
