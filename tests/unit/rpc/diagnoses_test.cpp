/// Diagnoses over a real socket: stored, found again, confirmed by runs of a made-up worker.
#include <google/protobuf/util/message_differencer.h>

#include <algorithm>
#include <cmath>

#include "scheduler/gap/bank.h"
#include "scheduler/rpc/confirmation.h"
#include "scheduler/rpc/submission.h"
#include "support/made_up_gap.h"
#include "unit/rpc/service_fixture.h"

namespace regolab {
namespace {

using test::MadeUpGap;
using testing::HasSubstr;

struct Diagnoses : test::ServiceTest {
  std::string kernels;
  int workers = 0;  ///< so far: each has a name of its own

  void SetUp() override {
    static std::string fitted;  // once: it is the slow part
    if (fitted.empty()) {
      v1::EmulateRequest request;
      request.set_bank_csv(MadeUpGap::bank_csv()), request.set_file_name("bank.csv");
      v1::EmulateReply reply;
      ASSERT_TRUE(client->call(*client->gaps, &v1::Gaps::Stub::Emulate, request, &reply, std::chrono::seconds(300)).ok());
      fitted = reply.kernels_json();
    }
    kernels = fitted;
  }

  v1::DiagnoseRequest request(double cohesion, bool hold_out) const {
    v1::DiagnoseRequest out;
    out.mutable_measurements()->set_file_name("o.yaml");
    out.mutable_measurements()->set_content(MadeUpGap::observations_yaml("made up", 0.6, 4, cohesion, 0));
    out.set_bank_csv(MadeUpGap::bank_csv()), out.set_bank_name("bank.csv"), out.set_kernels_json(kernels);
    out.set_hold_out(hold_out);
    return out;
  }

  v1::DiagnoseEvent diagnose(const v1::DiagnoseRequest& asked) {
    grpc::ClientContext context;
    const auto stream = client->gaps->Diagnose(&context, asked);
    v1::DiagnoseEvent last;
    for (v1::DiagnoseEvent event; stream->Read(&event);) last = event;
    const auto status = stream->Finish();
    EXPECT_TRUE(status.ok()) << status.error_message();
    return last;
  }

  v1::PlanReply plan(const std::string& id, unsigned first, unsigned draws, grpc::StatusCode code = grpc::StatusCode::OK) {
    v1::PlanRequest asked;
    asked.set_diagnosis(id), asked.set_first(first), asked.set_draws(draws);
    v1::PlanReply reply;
    const auto status = client->call(*client->gaps, &v1::Gaps::Stub::PlanConfirmation, asked, &reply);
    EXPECT_EQ(status.error_code(), code) << status.error_message();
    return reply;
  }

  std::string run(const v1::PlanReply& planned) {
    v1::SubmitReply submitted;
    EXPECT_TRUE(client->call(*client->experiments, &v1::Experiments::Stub::Submit, planned.design(), &submitted).ok());
    EXPECT_TRUE(submitted.diagnostics().empty()) << submitted.diagnostics(0).text();
    const Worker worker{*this, "w" + std::to_string(++workers), {.duration_s = 0}};
    client->wait(submitted.experiment());
    return submitted.experiment();
  }
};

TEST_F(Diagnoses, AreStoredWithTheirStepsAndKnownTheNextTime) {
  const auto first = diagnose(request(12000, false));
  EXPECT_FALSE(first.stored());
  EXPECT_EQ(first.diagnosis().verdict(), "EFFECT");
  EXPECT_EQ(first.diagnosis().repaired(), "cohesion");
  restart();
  const auto again = diagnose(request(12000, false));
  EXPECT_TRUE(again.stored());
  EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(again.diagnosis(), first.diagnosis()));
  EXPECT_FALSE(diagnose(request(5001, false)).stored()) << "other measurements are another question";
  v1::GetDiagnosisRequest get;
  get.set_id(first.diagnosis().id().substr(0, 8));
  v1::StoredDiagnosis stored;
  ASSERT_TRUE(client->call(*client->gaps, &v1::Gaps::Stub::GetDiagnosis, get, &stored).ok());
  EXPECT_EQ(stored.case_name(), "made up");
  const auto again_sampled = std::ranges::count_if(stored.steps(), [](const auto& step) { return step.name().starts_with("again: "); });
  EXPECT_GE(again_sampled, 1) << "the best";
  EXPECT_EQ(stored.steps_size(), first.diagnosis().models_size() + 1 + again_sampled) << "each hypothesis, and where";
  EXPECT_EQ(stored.measured().features_size(), 11);
  v1::ListDiagnosesReply list;
  ASSERT_TRUE(client->call(*client->gaps, &v1::Gaps::Stub::ListDiagnoses, {}, &list).ok());
  EXPECT_EQ(list.diagnoses_size(), 2);
}

TEST_F(Diagnoses, FittedForConfirmationSeeNothingOfWhatIsHeldOut) {
  const auto d = diagnose(request(12000, true)).diagnosis();
  ASSERT_EQ(d.held_out_size(), 2);
  EXPECT_EQ(d.features(), 7U) << "11 less two levels of two";
  int held = 0;
  for (const auto& g : d.where()) {
    for (const auto& level : d.held_out()) EXPECT_THAT(g.group(), testing::Not(HasSubstr(level)));
  }
  for (const auto& f : d.fits()) held += f.held_out() ? 1 : 0;
  EXPECT_EQ(held, 4);
  EXPECT_NE(d.id(), diagnose(request(12000, false)).diagnosis().id());
}

TEST_F(Diagnoses, ArePlannedAsStudiesOfDrawsUnderTheHeldOutStresses) {
  const auto d = diagnose(request(12000, true)).diagnosis();
  const auto planned = plan(d.id(), 0, 4);
  EXPECT_EQ(planned.dem_jobs(), 4U * 2 * 3) << "draws, models, settling and two stresses";
  EXPECT_LT(planned.core_s(), 0) << "nothing was timed here";
  const Submission study = prepare(planned.design());
  ASSERT_TRUE(study.diagnostics.empty());
  std::set<std::uint64_t> seeds;
  for (const Wish& wish : study.wishes) {
    const StageSpec& spec = wish.spec;
    seeds.insert(spec.seed);
    EXPECT_GE(spec.seed, 1'000'000U);
    EXPECT_EQ(spec.numerics.stress_stiffness_number, 0);
    EXPECT_EQ(spec.numerics.isotropic_servo_steps, 200);
    EXPECT_EQ(spec.numerics.clusters, 300);
    EXPECT_EQ(spec.micro.largest_diameter, 0.02);
    EXPECT_NE(spec.kind, StageKind::kRepose);
    EXPECT_EQ(spec.effects[EffectId::kCohesion] > 0, wish.point > 4) << "the base model first";
    if (spec.kind != StageKind::kStress) continue;
    EXPECT_TRUE(std::ranges::find(d.held_out_pa(), spec.confining_stress) != d.held_out_pa().end());
  }
  EXPECT_EQ(seeds.size(), 8U) << "a specimen of its own for each";
  const auto model = std::ranges::find_if(d.models(), [](const auto& m) { return m.model() == "cohesion"; });
  const auto fifth = std::ranges::find_if(study.wishes, [](const Wish& w) { return w.point == 5; });
  EXPECT_DOUBLE_EQ(fifth->spec.effects[EffectId::kCohesion], model->draws(0).strengths_si(0));
  for (const Wish& wish : prepare(plan(d.id(), 4, 4).design()).wishes) EXPECT_FALSE(seeds.contains(wish.spec.seed)) << "the next round has others";
  plan(d.id(), 8, 8, grpc::StatusCode::INVALID_ARGUMENT);
  plan(diagnose(request(12000, false)).diagnosis().id(), 0, 4, grpc::StatusCode::FAILED_PRECONDITION);
}

TEST_F(Diagnoses, AreConfirmedByTheRunsOfTheirPlanAndTheSecondTimeCostsNothing) {
  const v1::DiagnoseRequest asked = request(12000, true);
  const auto d = diagnose(asked).diagnosis();
  v1::ShrinkageRequest measure;
  *measure.mutable_of() = asked;
  measure.add_rounds(4), measure.add_rounds(2);
  v1::StoredDiagnosis stored;
  EXPECT_EQ(client->call(*client->gaps, &v1::Gaps::Stub::MeasureShrinkage, measure, &stored).error_code(), grpc::StatusCode::FAILED_PRECONDITION) << "nothing was run";
  const std::string label = run(plan(d.id(), 0, 4));
  run(plan(d.id(), 4, 2));
  EXPECT_EQ(plan(d.id(), 0, 4).dem_jobs(), 0U);
  const auto status = client->call(*client->gaps, &v1::Gaps::Stub::MeasureShrinkage, measure, &stored);
  ASSERT_TRUE(status.ok()) << status.error_message();
  const v1::Shrinkage& s = stored.diagnosis().shrinkage();
  EXPECT_EQ(s.model(), "cohesion");
  EXPECT_EQ(s.draws(), 6U);
  EXPECT_EQ(s.experiments_size(), 2);
  EXPECT_EQ(s.heldout_size(), 2);
  ASSERT_TRUE(s.has_s() || !s.undefined().empty());
  EXPECT_TRUE(s.has_emulator_s());
  EXPECT_GT(s.emulator_s(), 0.5) << "in its own world the effect explains what was held out";
  // By hand: means of what the made-up worker measured in the first round, of the rows without the effect.
  ASSERT_FALSE(s.features().empty());
  const v1::FittedFeature& f = s.features(0);
  EXPECT_THAT(f.id(), HasSubstr("sigma1_ratio_"));
  EXPECT_EQ(f.base_runs(), 6U);
  const std::string response = "sigma1_at_sigma3_" + f.id().substr(f.id().rfind('_') + 1) + "kPa";
  double sum = 0;
  int n = 0;
  for (const std::string& one : {s.experiments(0), s.experiments(1)}) {
    const auto table = client->table(one);
    for (const auto& row : table.rows()) {
      if (row.point() <= (one == label ? 4 : 2)) sum += std::log(row.value_si().at(response)), ++n;
    }
  }
  EXPECT_EQ(n, 6);
  EXPECT_NEAR(f.base(), std::exp(sum / n) / 1000, 1e-9);

  const auto again = diagnose(asked);
  EXPECT_TRUE(again.stored());
  EXPECT_EQ(again.diagnosis().shrinkage().SerializeAsString(), s.SerializeAsString());
  EXPECT_EQ(diagnose(request(12000, false)).diagnosis().shrinkage().draws(), 6U) << "shown beside the diagnosis of the whole set too";
}

TEST(FirstSeed, IsAwayFromTheBanks) {
  const std::string id(64, '0');
  const auto free = first_seed_of(id, {1, 2, 3});
  EXPECT_EQ(first_seed_of(id, {}), free);
  const auto moved = first_seed_of(id, {free + 3, free + 60});
  EXPECT_GT(moved, free + 60);
  EXPECT_NE(first_seed_of(std::string(64, '1'), {}), free);
}

}  // namespace
}  // namespace regolab
