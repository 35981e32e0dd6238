#include "worker/rpc/link.h"

#include <grpcpp/grpcpp.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "digest/sha256.h"
#include "regolab/v1/work.grpc.pb.h"

namespace regolab {
namespace {

constexpr std::size_t kPiece = 256 * 1024;
constexpr std::chrono::seconds kSlack{10};  // beyond the time a call may be held
constexpr std::chrono::seconds kTransferLimit{120};

Error to_error(const grpc::Status& status) {
  Code code = Code::kInternal;
  switch (status.error_code()) {
    case grpc::StatusCode::UNAVAILABLE:
    case grpc::StatusCode::DEADLINE_EXCEEDED: code = Code::kUnavailable; break;
    case grpc::StatusCode::NOT_FOUND: code = Code::kNotFound; break;
    case grpc::StatusCode::DATA_LOSS: code = Code::kDataLoss; break;
    case grpc::StatusCode::FAILED_PRECONDITION: code = Code::kFailedPrecondition; break;
    case grpc::StatusCode::RESOURCE_EXHAUSTED: code = Code::kResourceExhausted; break;
    case grpc::StatusCode::INVALID_ARGUMENT: code = Code::kInvalidArgument; break;
    case grpc::StatusCode::ABORTED: code = Code::kAborted; break;
    case grpc::StatusCode::CANCELLED: code = Code::kCancelled; break;
    default: break;
  }
  return {code, status.error_message()};
}

grpc::ChannelArguments arguments() {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 100);  // a scheduler that restarts is back within seconds
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS,
                   5000);  // one attempt may take so long: a busy scheduler is slow to greet
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 1000);
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  return arguments;
}

/// Outlives sync() if the library calls back late.
struct Call {
  grpc::ClientContext context;
  v1::SyncRequest request;
  v1::SyncReply reply;
  grpc::Status status;
  bool done = false;
};

}  // namespace

struct Link::State {
  explicit State(const std::string& server)
      : channel(grpc::CreateCustomChannel(server, grpc::InsecureChannelCredentials(), arguments())),
        pool(v1::WorkerPool::NewStub(channel)),
        artifacts(v1::Artifacts::NewStub(channel)) {}
  std::shared_ptr<grpc::Channel> channel;
  std::unique_ptr<v1::WorkerPool::Stub> pool;
  std::unique_ptr<v1::Artifacts::Stub> artifacts;
  std::mutex mutex;
  std::condition_variable changed;
  bool woken = false;  ///< guarded by mutex, as is Call::done
};

Link::Link(const std::string& server) : state_(std::make_unique<State>(server)) {}
Link::~Link() = default;

Result<v1::SyncReply> Link::sync(const v1::SyncRequest& request) {
  auto call = std::make_shared<Call>();
  call->request = request;
  call->context.set_deadline(std::chrono::system_clock::now() + kSlack + std::chrono::milliseconds(request.hold_ms()));
  State& state = *state_;
  state.pool->async()->Sync(&call->context, &call->request, &call->reply, [call, &state](grpc::Status status) {
    const std::lock_guard lock(state.mutex);
    call->status = std::move(status);
    call->done = true;
    state.changed.notify_all();
  });
  std::unique_lock lock(state.mutex);
  state.changed.wait(lock, [&] { return call->done || state.woken; });
  if (!call->done) {
    call->context.TryCancel();
    state.changed.wait(lock, [&] { return call->done; });
  }
  if (!call->status.ok()) return to_error(call->status);
  return std::move(call->reply);
}

void Link::wake() {
  const std::lock_guard lock(state_->mutex);
  state_->woken = true;
  state_->changed.notify_all();
}

void Link::clear_wake() {
  const std::lock_guard lock(state_->mutex);
  state_->woken = false;
}

Result<std::string> Link::upload(const std::string& bytes) {
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + kTransferLimit);
  v1::UploadReply reply;
  const auto writer = state_->artifacts->Upload(&context, &reply);
  v1::Chunk chunk;
  chunk.set_digest(sha256_hex(bytes));
  for (std::size_t offset = 0; offset < bytes.size(); offset += kPiece) {
    chunk.set_offset(offset);
    chunk.set_data(bytes.substr(offset, kPiece));
    if (!writer->Write(chunk)) break;  // Finish() says why
  }
  writer->WritesDone();
  if (const grpc::Status status = writer->Finish(); !status.ok()) return to_error(status);
  return reply.digest();
}

Result<std::string> Link::download(const std::string& digest) {
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + kTransferLimit);
  v1::DownloadRequest request;
  request.set_digest(digest);
  const auto reader = state_->artifacts->Download(&context, request);
  std::string bytes;
  for (v1::Chunk chunk; reader->Read(&chunk);) bytes += chunk.data();
  if (const grpc::Status status = reader->Finish(); !status.ok()) return to_error(status);
  if (sha256_hex(bytes) != digest)
    return Error{Code::kUnavailable, "artifact " + digest + " was damaged on the way, asking again"};
  return bytes;
}

}  // namespace regolab
