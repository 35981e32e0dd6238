#include "client/blind/sealed_truths.h"

#include <fmt/format.h>

#include "client/file_read.h"
#include "digest/sha256.h"
#include "seal/seal.h"

namespace regolab::client {

namespace {

constexpr std::size_t kLargestTruth = 1 << 20;  // [bytes]
constexpr std::size_t kBlock = 4096;            // [bytes] sealed truths are multiples of it: their sizes tell nothing

std::string padded(std::string text) {
  text.append(kBlock - text.size() % kBlock, ' ');
  return text;
}

}  // namespace

Outcome seal_truths(const pb::BlindDrawReply& drawn, const std::string& key, const BlindSet& set, BlindFolder& folder) {
  std::vector<Digest> commitments;
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& truth : drawn.truths()) {
    commitments.push_back({truth.id(), sha256_hex(truth.text())});
    auto bytes = sealed(key, padded(truth.text()), truth.id());
    if (!bytes.ok()) return failed(Exit::kInternal, bytes.error().text);
    all.emplace_back(truth.id(), std::move(*bytes));
  }
  return folder.write_set(set, commitments, all);
}

Outcome open_truth(const BlindFolder& folder, const Digest& commitment, const std::string& key, std::string& text) {
  std::string bytes;
  if (auto got = read_whole_file(folder.sealed_file(commitment.id), kLargestTruth, "a sealed truth", bytes); !got.ok()) return got;
  auto truth = opened(key, bytes, commitment.id);
  if (!truth.ok()) return failed(Exit::kInvalidInput, fmt::format("{}: {}", folder.sealed_file(commitment.id).string(), truth.error().text));
  truth->resize(truth->find_last_not_of(' ') + 1);
  if (sha256_hex(*truth) != commitment.sha256) {
    return failed(
        Exit::kInvalidInput,
        fmt::format("case {}: the truth is not the one committed to (its SHA-256 is another) this set proves nothing: make another", commitment.id));
  }
  text = std::move(*truth);
  return done();
}

}  // namespace regolab::client
