#include "scheduler/rpc/server.h"

#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/health_check_service_interface.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <utility>

#include "scheduler/rpc/address.h"
#include "scheduler/rpc/artifacts.h"
#include "scheduler/rpc/blind.h"
#include "scheduler/rpc/experiments.h"
#include "scheduler/rpc/gaps.h"
#include "scheduler/rpc/results.h"
#include "scheduler/rpc/surrogates.h"
#include "scheduler/rpc/watch.h"
#include "scheduler/rpc/worker_pool.h"

namespace regolab {
namespace {
constexpr int kLargestMessage = 18 << 20;  // inbound: a file of measurements (16 MiB) with its map
constexpr std::chrono::seconds kPatience{2};
}  // namespace

struct Server::State {
  State(std::unique_ptr<Desk> opened, const std::string& database)
      : desk(std::move(opened)), hub(*desk), pool(*desk), artifacts(*desk), experiments(*desk, hub), results(database), surrogates(*desk, database), gaps(*desk, database), blind(database) {}

  std::unique_ptr<Desk> desk;
  WatchHub hub;
  WorkerPoolService pool;
  ArtifactsService artifacts;
  ExperimentsService experiments;
  ResultsService results;
  SurrogatesService surrogates;
  GapsService gaps;
  BlindService blind;
  std::unique_ptr<grpc::Server> server;
  std::string address;
};

Server::Server(std::unique_ptr<State> state) : state_(std::move(state)) {}

const std::string& Server::address() const { return state_->address; }

Result<std::unique_ptr<Server>> Server::start(ServerOptions options) {
  if (auto free = check_address(options.listen); !free.ok()) return free.error();
  auto store = Store::open(options.database);
  if (!store.ok()) return store.error();
  static grpc::Server* serving = nullptr;  // for the health service: one server per process
  Desk::Options desk_options{.policy = options.policy, .on_fatal = options.on_fatal, .on_health = [](bool healthy) {
                               if (serving && serving->GetHealthCheckService()) {
                                 serving->GetHealthCheckService()->SetServingStatus(healthy);
                               }
                             }};
  auto desk = Desk::open(std::move(*store), std::move(desk_options));
  if (!desk.ok()) return desk.error();
  auto state = std::make_unique<State>(std::move(*desk), options.database);

  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  grpc::ServerBuilder builder;
  int port = 0;
  builder.AddListeningPort(options.listen, grpc::InsecureServerCredentials(), &port);
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);  // else a second server would share the port without a word
  builder.SetMaxReceiveMessageSize(kLargestMessage);
  builder.RegisterService(&state->pool);
  builder.RegisterService(&state->artifacts);
  builder.RegisterService(&state->experiments);
  builder.RegisterService(&state->results);
  builder.RegisterService(&state->surrogates);
  builder.RegisterService(&state->gaps);
  builder.RegisterService(&state->blind);
  state->server = builder.BuildAndStart();
  if (!state->server || port == 0) {
    return Error{Code::kAlreadyExists,
                 "cannot listen on " + options.listen + " (the system refused), choose another address"};
  }
  serving = state->server.get();
  state->desk->start();
  const bool is_unix = options.listen.starts_with("unix:");
  state->address = is_unix ? options.listen : options.listen.substr(0, options.listen.rfind(':') + 1) + std::to_string(port);
  return std::unique_ptr<Server>(new Server(std::move(state)));
}

Server::~Server() {
  state_->hub.close_all();  // needs the desk
  state_->desk->stop();     // answers held calls; what comes later is refused at once
  if (state_->server) state_->server->Shutdown(std::chrono::system_clock::now() + kPatience);
}

}  // namespace regolab
