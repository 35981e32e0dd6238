/// A client for tests: one call per function, errors as gtest failures.
#pragma once
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "regolab/v1/lab.grpc.pb.h"
#include "regolab/v1/work.grpc.pb.h"

namespace regolab::test {

/// Four points of an L4, `stresses` stress tests each; seeds from 1.
inline std::string l4_yaml(int seeds = 1, const std::string& name = "four points", const std::string& more = "") {
  return "name: " + name + "\nprofile: quick\nparticles: 120\nseeds: " + std::to_string(seeds) +
         "\nfactors:\n  theta_F: [5 degree, 40 degree]\n  N_E: [2, 6]\nfixed:\n  K_N: 5e4 N/m\n  eta_N: 0.5 N s/m\n"
         "  K_T: 5e4 N/m\n  eta_T: 0.5 N s/m\n  L_S: 2 cm\n  rotation: xz\narray: L4\ntests: [settle, repose, stress]\n"
         "stress: {sigma3: [2.5 kPa, 5 kPa]}\n" +
         more;
}

class LabClient {
 public:
  explicit LabClient(const std::string& address)
      : channel_(grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments())),
        experiments(v1::Experiments::NewStub(channel_)),
        results(v1::Results::NewStub(channel_)),
        gaps(v1::Gaps::NewStub(channel_)),
        pool(v1::WorkerPool::NewStub(channel_)),
        artifacts(v1::Artifacts::NewStub(channel_)) {}

  template <class Request, class Reply, class Stub>
  grpc::Status call(Stub& stub, grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Reply*),
                    const Request& request, Reply* reply, std::chrono::seconds limit = std::chrono::seconds(20)) {
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + limit);
    return (stub.*method)(&context, request, reply);
  }

  v1::SubmitReply submit(const std::string& yaml, const std::string& request_id = "") {
    v1::SubmitRequest request;
    request.set_file_name("study.yaml");
    request.set_design_yaml(yaml);
    request.set_request_id(request_id);
    v1::SubmitReply reply;
    grpc::ClientContext context;
    const auto status = experiments->Submit(&context, request, &reply);
    EXPECT_TRUE(status.ok()) << status.error_message();
    for (const auto& d : reply.diagnostics()) ADD_FAILURE() << d.file() << ":" << d.line() << ": " << d.text();
    return reply;
  }
  v1::ExperimentStatus status(const std::string& experiment) {
    v1::GetRequest request;
    request.set_experiment(experiment);
    v1::ExperimentStatus reply;
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(20));
    const auto status = experiments->Get(&context, request, &reply);
    if (!status.ok()) reply.set_state("unreachable");
    return reply;
  }
  v1::ExperimentStatus wait(const std::string& experiment, std::chrono::seconds limit = std::chrono::seconds(60)) {
    const auto until = std::chrono::steady_clock::now() + limit;
    v1::ExperimentStatus now = status(experiment);
    while ((now.state() == "running" || now.state() == "unreachable") && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      now = status(experiment);
    }
    return now;
  }
  std::vector<v1::WatchEvent> watch(const std::string& experiment, std::uint64_t from_seq = 0) {
    v1::WatchRequest request;
    request.set_experiment(experiment);
    request.set_from_seq(from_seq);
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(60));
    const auto reader = experiments->Watch(&context, request);
    std::vector<v1::WatchEvent> events;
    for (v1::WatchEvent event; reader->Read(&event);) events.push_back(event);
    EXPECT_TRUE(reader->Finish().ok());
    return events;
  }
  v1::ResultsReply table(const std::string& experiment) {
    v1::ResultsRequest request;
    request.set_experiment(experiment);
    v1::ResultsReply reply;
    grpc::ClientContext context;
    const auto status = results->GetResults(&context, request, &reply);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return reply;
  }
  /// Every stage with its numbers, serialised: equal text, equal bits (but for times, worker and order).
  std::map<std::string, std::string> results_by_key(const std::string& experiment) {
    v1::ExportRequest request;
    request.set_experiment(experiment);
    grpc::ClientContext context;
    const auto reader = results->Export(&context, request);
    std::map<std::string, std::string> out;
    for (v1::ExportItem item; reader->Read(&item);)
      out[item.stage_key()] = item.state() + " " + item.result().SerializeAsString();
    EXPECT_TRUE(reader->Finish().ok());
    return out;
  }

 private:
  static grpc::ChannelArguments arguments() {
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 50);
    // Also how long an attempt may take: a busy machine is slow to greet. A refused attempt is repeated after the other two.
    arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, 20'000);
    arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 200);
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    return arguments;
  }
  std::shared_ptr<grpc::Channel> channel_;

 public:
  std::unique_ptr<v1::Experiments::Stub> experiments;
  std::unique_ptr<v1::Results::Stub> results;
  std::unique_ptr<v1::Gaps::Stub> gaps;
  std::unique_ptr<v1::WorkerPool::Stub> pool;
  std::unique_ptr<v1::Artifacts::Stub> artifacts;
};

}  // namespace regolab::test
