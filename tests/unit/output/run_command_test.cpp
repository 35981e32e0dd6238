#include "worker/output/run_command.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "unit/output/fake_stages.h"
#include "unit/output/temporary_folder.h"
#include "worker/output/atomic_file.h"
#include "worker/output/progress_line.h"

namespace regolab {
namespace {

using test::FakeStages;
using test::TemporaryFolder;
using ::testing::HasSubstr;

constexpr const char* kJob = R"(profile: quick
seed: 1
micro: {theta_F: 20 degree, K_N: 1e5 N/m, eta_N: 0.25 N.s/m, K_T: 7.5e4 N/m, eta_T: 1 N.s/m, L_S: 1 cm, N_E: 6, rotation: none}
tests: [settle, repose, stress]
stress: {sigma3: [1.25 kPa, 2.5 kPa]}
)";

struct Ran {
  int code;
  std::string out, err;
};

class RunCommandTest : public testing::Test {
 protected:
  Ran run(const std::string& job_text, bool quiet = true) {
    EXPECT_TRUE(write_whole_file(folder_ / "job.yaml", job_text).ok());
    const RunDoors doors{
        .run_stage = [this](const StageSpec& spec, const std::string& bed, const std::string& checkpoint,
                            const StageHooks& hooks) { return fake_.run(spec, bed, checkpoint, hooks); },
        .breach_of = [](const StageSpec& spec) { return spec.seed == 666 ? "seed=666 (unlucky) take another" : ""; },
        .view_bed = test::view_fake_bed,
        .stop = stop_.get_token()};
    std::ostringstream out, err;
    const int code =
        run_command({.job_file = folder_ / "job.yaml", .directory = folder_ / "out", .quiet = quiet}, doors, out, err);
    return {code, out.str(), err.str()};
  }
  bool stands(const char* name) const { return std::filesystem::exists(folder_.path() / "out" / name); }

  TemporaryFolder folder_;
  FakeStages fake_;
  std::stop_source stop_;
};

TEST_F(RunCommandTest, LeavesEveryFileAndNoCheckpoints) {
  const Ran ran = run(kJob);
  EXPECT_EQ(ran.code, kExitDone) << ran.err;
  for (const char* name :
       {"result.json", "observations.yaml", "bed.vtp", "bed.xyz", "contacts.vtp", "repose.vtp", "repose.xyz",
        "curves/repose_profile.csv", "curves/sigma1_at_sigma3_2.5kPa.csv", "curves/kinetic_energy.csv"}) {
    EXPECT_TRUE(stands(name)) << name;
  }
  EXPECT_FALSE(stands(".checkpoint"));
}

TEST_F(RunCommandTest, RunAgainDoesNothing) {
  ASSERT_EQ(run(kJob).code, kExitDone);
  fake_.started.clear();
  const Ran again = run(kJob);
  EXPECT_EQ(again.code, kExitDone);
  EXPECT_THAT(again.out, HasSubstr("done before"));
  EXPECT_TRUE(fake_.started.empty());
  EXPECT_FALSE(stands(".checkpoint"));
}

TEST_F(RunCommandTest, RefusesTheResultsOfAnotherJob) {
  ASSERT_EQ(run(kJob).code, kExitDone);
  std::string other = kJob;
  other.replace(other.find("seed: 1"), 7, "seed: 2");
  const Ran ran = run(other);
  EXPECT_EQ(ran.code, kExitInvalid);
  EXPECT_THAT(ran.err, HasSubstr("its result.json is of another job"));
}

TEST_F(RunCommandTest, RefusesToOverwriteObservationsThatAreNotIts) {
  ASSERT_TRUE(make_writable_folder(folder_ / "out").ok());
  ASSERT_TRUE(write_whole_file(folder_ / "out/observations.yaml", "format: observations/1\n").ok());
  const Ran ran = run(kJob);
  EXPECT_EQ(ran.code, kExitInvalid);
  EXPECT_THAT(ran.err, HasSubstr("would be overwritten"));
  EXPECT_FALSE(stands(".checkpoint"));
}

TEST_F(RunCommandTest, SaysWhereTheJobFileIsWrongAndWritesNothing) {
  const Ran ran = run("profile: quick\nsead: 1\n");
  EXPECT_EQ(ran.code, kExitInvalid);
  EXPECT_THAT(ran.err, HasSubstr("job.yaml:2:1:"));
  EXPECT_FALSE(stands(""));
}

TEST_F(RunCommandTest, RefusesWhatTheEngineWouldRefuse) {
  std::string unlucky = kJob;
  unlucky.replace(unlucky.find("seed: 1"), 7, "seed: 666");
  const Ran ran = run(unlucky);
  EXPECT_EQ(ran.code, kExitInvalid);
  EXPECT_THAT(ran.err, HasSubstr("unlucky"));
  EXPECT_FALSE(stands(""));
}

TEST_F(RunCommandTest, AnUnphysicalEndIsStoredAndPrintedWithCodeFive) {
  fake_.end_of = [](const StageSpec& spec) {
    return spec.kind == StageKind::kRepose ? StageEnd::kOverlap : StageEnd::kCompleted;
  };
  const Ran ran = run(kJob);
  EXPECT_EQ(ran.code, kExitUnphysical);
  EXPECT_THAT(ran.err, HasSubstr("repose ended as overlap: grains overlap too much"));
  const auto json = nlohmann::json::parse(*read_whole_file(folder_ / "out/result.json"));
  EXPECT_EQ(json["end"], "overlap");
  EXPECT_EQ(run(kJob).code, kExitUnphysical) << "the second time too";
}

TEST_F(RunCommandTest, InterruptedLeavesOnlyTheCheckpointAndGoesOnLater) {
  fake_.at_step = [this](const StageSpec&, std::uint64_t step) {
    if (step == 50) stop_.request_stop();
  };
  const Ran cut = run(kJob);
  EXPECT_EQ(cut.code, kExitInterrupted);
  EXPECT_THAT(cut.err, HasSubstr("interrupted"));
  EXPECT_FALSE(stands("result.json"));
  stop_ = {};
  fake_.at_step = nullptr;
  EXPECT_EQ(run(kJob).code, kExitDone);
  EXPECT_EQ(fake_.steps_done, 5 * fake_.steps);
}

TEST_F(RunCommandTest, RefusesAFolderThatIsAFile) {
  ASSERT_TRUE(write_whole_file(folder_ / "out", "x").ok());
  const Ran ran = run(kJob);
  EXPECT_EQ(ran.code, kExitInvalid);
  EXPECT_THAT(ran.err, HasSubstr("choose another folder"));
}

TEST(ProgressText, NamesStagePhaseShareStepsRateAndTimeLeft) {
  StagePlace place{.spec = {}, .number = 4, .count = 7};
  place.spec.kind = StageKind::kStress;
  place.spec.confining_stress = 2500;
  EXPECT_EQ(progress_text(place, {"shear", 0.45, 12000, 2.1e6}, 65.0),
            "[4/7] stress at 2.5 kPa: shear, 45 %, 12000 steps, 2.1e+06 sphere-steps/s, 1:05 left");
}

TEST(ProgressLine, CountsTimeLeftFromWhereAResumedStageStarted) {
  double now = 100;
  std::ostringstream out;
  ProgressLine line(out, true, [&now] { return now; });
  const StagePlace place{.spec = {}, .number = 1, .count = 2};
  line.show(place, {"sedimentation", 0.50, 1000, 1e6});
  EXPECT_EQ(out.str().find("left"), std::string::npos) << "nothing is known yet";
  now = 110;
  line.show(place, {"sedimentation", 0.75, 1500, 1e6});
  EXPECT_THAT(out.str(), HasSubstr("0:10 left"));
}

TEST(ProgressLine, OffATerminalWritesALineEveryHalfMinute) {
  double now = 0;
  std::ostringstream out;
  ProgressLine line(out, false, [&now] { return now; });
  const StagePlace place{.spec = {}, .number = 1, .count = 2};
  for (; now < 61; now += 1) line.show(place, {"sedimentation", now / 100, 1, 1});
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}

}  // namespace
}  // namespace regolab
