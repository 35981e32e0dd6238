/// A scheduler: store, desk and services behind one address.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "scheduler/queue/job_queue.h"
#include "vocab/result.h"

namespace regolab {

struct ServerOptions {
  std::string database;
  std::string listen;  ///< "host:port" (port 0: any free one) or "unix:/path"
  QueuePolicy policy;
  std::function<void(const Error&)> on_fatal;  ///< the database can no longer be trusted: must end the process
};

class Server {
 public:
  /// kInvalidArgument: no such address; kAlreadyExists: somebody listens there; kFailedPrecondition: the database is in use,
  /// newer, or not ours; kResourceExhausted: disk full.
  static Result<std::unique_ptr<Server>> start(ServerOptions options);
  ~Server();  ///< answers what is held, then stops

  const std::string& address() const;  ///< as bound

 private:
  struct State;
  explicit Server(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace regolab
