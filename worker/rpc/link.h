/// The wire to a scheduler: calls with deadlines that may be interrupted, and artifacts in pieces. No gRPC in sight.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "regolab/v1/work.pb.h"
#include "vocab/result.h"

namespace regolab {

class Link {
 public:
  /// `server`: "unix:/path" or "host:port". Nothing is connected before the first call.
  explicit Link(const std::string& server);
  ~Link();

  /// One Sync. `wake()` calls it back at once with kCancelled. Errors: kUnavailable (nobody there; try again), others as the
  /// scheduler words them.
  Result<v1::SyncReply> sync(const v1::SyncRequest& request);
  /// Ends a sync() under way, or the next one if none is. Any thread.
  void wake();
  void clear_wake();

  /// The artifact's digest, once it is durable over there.
  Result<std::string> upload(const std::string& bytes);
  /// Verified against the digest. kNotFound, kDataLoss, kUnavailable.
  Result<std::string> download(const std::string& digest);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace regolab
