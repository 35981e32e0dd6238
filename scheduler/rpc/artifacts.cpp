#include "scheduler/rpc/artifacts.h"

#include "scheduler/rpc/grpc_status.h"

namespace regolab {
namespace {

constexpr std::uint64_t kLargest = 512ULL << 20;
constexpr std::size_t kPiece = 256 * 1024;

}  // namespace

grpc::Status ArtifactsService::Upload(grpc::ServerContext*, grpc::ServerReader<v1::Chunk>* reader, v1::UploadReply* reply) {
  v1::Chunk chunk;
  if (!reader->Read(&chunk)) return to_grpc(invalid("upload refused (no bytes came)"));
  const std::string digest = chunk.digest();
  auto upload = desk_.files().begin(digest);
  if (!upload.ok()) return to_grpc(upload.error());
  do {
    if (chunk.digest() != digest || chunk.offset() != upload->size()) {
      return to_grpc(invalid("upload refused (a piece of another file, or out of order), send it again"));
    }
    if (upload->size() + chunk.data().size() > kLargest) {
      return to_grpc(
          invalid("upload refused (larger than " + std::to_string(kLargest >> 20) + " MiB), use fewer particles"));
    }
    if (auto added = upload->add(chunk.data()); !added.ok()) return to_grpc(added.error());
  } while (reader->Read(&chunk));
  if (auto finished = upload->finish(); !finished.ok()) return to_grpc(finished.error());
  const auto stored = desk_.ask(Desk::Need::kWrite, [&, bytes = upload->size()](Desk::Turn& turn) -> Result<void> {
    if (!turn.store.files().has(digest)) return Error{Code::kAborted, "the file was swept away meanwhile, send it again"};
    turn.rows = turn.begin();
    if (turn.rows.ok()) turn.rows = turn.store.add_artifact(digest, bytes, turn.unix_ms);
    return turn.rows;
  });
  if (!stored.ok()) return to_grpc(stored.error());
  reply->set_digest(digest);
  return grpc::Status::OK;
}

grpc::Status ArtifactsService::Download(grpc::ServerContext*, const v1::DownloadRequest* request,
                                        grpc::ServerWriter<v1::Chunk>* writer) {
  const std::string& digest = request->digest();
  const auto bytes = desk_.files().read(digest);
  if (!bytes.ok()) {
    if (bytes.error().code != Code::kInvalidArgument) {
      const auto noted = desk_.ask(Desk::Need::kWrite, [&](Desk::Turn& turn) -> Result<void> {
        turn.queue.bed_lost(digest, turn.now, turn.effects);
        turn.queue.checkpoint_lost(digest, turn.effects);
        return {};
      });
      if (!noted.ok()) return to_grpc(noted.error());
    }
    return to_grpc(bytes.error());
  }
  v1::Chunk chunk;
  chunk.set_digest(digest);
  for (std::size_t offset = request->offset(); offset < bytes->size(); offset += kPiece) {
    chunk.set_offset(offset);
    chunk.set_data(bytes->substr(offset, kPiece));
    if (!writer->Write(chunk)) return {grpc::StatusCode::CANCELLED, "the reader has gone"};
  }
  return grpc::Status::OK;
}

}  // namespace regolab
