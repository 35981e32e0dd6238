/// The blind part of the fake scheduler: truths that are lines of text, cases that are measured at once.
#pragma once
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "regolab/v1/lab.grpc.pb.h"

namespace regolab::client {

class FakeBlind final : public v1::Blind::Service {
 public:
  // What it answers. Set before calls are made.
  std::function<void()> on_design = [] {};  ///< a case is about to run
  int fail_observing_after = -1;            ///< so many cases, then the call breaks; -1 = never

  // What it was asked.
  int drawn = 0, observed = 0;
  std::vector<v1::BlindScoreRequest> scored;  ///< of the last call: bank, then cases

  static std::string truth_of(int k) { return "{\"truth\": \"cohesion of case " + std::to_string(k) + "\"}\n"; }

 private:
  grpc::Status Draw(grpc::ServerContext*, const v1::BlindDrawRequest* in, v1::BlindDrawReply* out) override {
    ++drawn;
    if (in->secret().size() != 32) return {grpc::StatusCode::INVALID_ARGUMENT, "secret"};
    for (int k = 0; k < static_cast<int>(in->cases() + in->nulls()); ++k) {
      auto& truth = *out->add_truths();
      truth.set_id("case" + std::to_string(k)), truth.set_text(truth_of(k));
    }
    return grpc::Status::OK;
  }
  grpc::Status Design(grpc::ServerContext*, const v1::BlindTruth*, v1::BlindDesignReply* out) override {
    on_design();
    out->add_designs()->set_design_yaml("name: one\n");
    return grpc::Status::OK;
  }
  grpc::Status Observe(grpc::ServerContext*, const v1::BlindObserveRequest* in, v1::BlindObserveReply* out) override {
    if (fail_observing_after >= 0 && observed >= fail_observing_after) return {grpc::StatusCode::INTERNAL, "killed here"};
    ++observed;
    out->set_file("observations of " + in->truth().id() + "\n");
    out->set_stages(12);
    return grpc::Status::OK;
  }
  grpc::Status Score(grpc::ServerContext*, grpc::ServerReader<v1::BlindScoreRequest>* in, v1::BlindScoreReply* out) override {
    scored.clear();
    for (v1::BlindScoreRequest message; in->Read(&message);) scored.push_back(message);
    out->set_record_csv("case\n"), out->set_score_json("{}\n"), out->set_text("top1\n");
    return grpc::Status::OK;
  }
};

}  // namespace regolab::client
