/// Watch streams: events numbered without gaps, and a fresh status about once a second.
#pragma once
#include <list>
#include <memory>
#include <string>

#include "regolab/v1/lab.grpc.pb.h"
#include "scheduler/rpc/desk.h"

namespace regolab {

class Watcher;

/// Lives on the desk's thread, except open().
class WatchHub {
 public:
  explicit WatchHub(Desk& desk);  ///< becomes the desk's listener
  ~WatchHub();

  /// A stream from event `from_seq` on (0 and 1: all of them). gRPC owns what is returned.
  grpc::ServerWriteReactor<v1::WatchEvent>* open(const std::string& label, std::uint64_t from_seq);
  /// Ends every stream with UNAVAILABLE; a client comes back to the next scheduler.
  void close_all();

 private:
  void on_commit(Desk::Turn& turn, const std::set<ExperimentId>& touched, bool periodic);
  Desk& desk_;
  std::list<std::shared_ptr<Watcher>> watchers_;
};

}  // namespace regolab
