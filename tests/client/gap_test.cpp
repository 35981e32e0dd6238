/// Diagnoses through the programs: stored, killed and taken up again, listed, shown, reported.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/client/programs.h"
#include "tests/support/made_up_gap.h"

namespace regolab {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class Gap : public Programs {
 protected:
  void SetUp() override {
    Programs::SetUp();
    write("bank.csv", test::MadeUpGap::bank_csv());
    write("o.yaml", test::MadeUpGap::observations_yaml("made-up", 0.6, 4, 12000, 0));
    const Ran ran = regolab("gap emulate bank.csv -o kernels.json");
    ASSERT_EQ(ran.code, 0) << ran.err;
  }
  static constexpr const char* kBank = " --bank bank.csv --kernels kernels.json";

  /// Starts a diagnosis with every step held up, waits for `steps` of evidence, then does `harm` with $client.
  Ran diagnose_and(const std::string& harm, int steps) {
    return shell("$regolab gap diagnose o.yaml" + std::string(kBank) + " --json >out.json 2>err.txt & client=$!\n" +
                 "for i in $(seq 600); do [ $(grep -c evidence err.txt) -ge " + std::to_string(steps) + " ] && break; sleep 0.02; done\n" + harm + "\nwait $client");
  }
  /// All of an answer but the name of its document.
  json answer(const std::string& text) {
    json out = json::parse(text);
    out.erase("format");
    return out;
  }
};

TEST_F(Gap, ADiagnosisThatWasKilledEndsWithTheSameAnswer) {
  const Ran calm = regolab("gap diagnose o.yaml --json --db calm.db" + std::string(kBank));
  ASSERT_EQ(calm.code, 0) << calm.err;
  EXPECT_EQ(answer(calm.out)["verdict"], "EFFECT");

  diagnose_and("kill -9 $client; sleep 1", 2);  // its scheduler ends with it
  const json left = json::parse(regolab("gap ls --json").out);
  ASSERT_EQ(left["diagnoses"].size(), 1U);
  ASSERT_EQ(left["diagnoses"][0]["finished"], false) << "killed too late to tell";
  EXPECT_GE(left["diagnoses"][0]["steps"], 1);
  EXPECT_EQ(regolab("gap report o.yaml -o r.html").code, 3) << "not before it has ended";

  const Ran again = regolab("gap diagnose o.yaml --json" + std::string(kBank));
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.out, calm.out) << "to the last digit";
  const Ran once_more = regolab("gap diagnose o.yaml --json" + std::string(kBank));
  EXPECT_THAT(once_more.err, HasSubstr("is known already"));
  EXPECT_EQ(once_more.out, calm.out);
}

TEST_F(Gap, ASchedulerKilledUnderADiagnosisIsNotNoticedInTheAnswer) {
  const Ran calm = regolab("gap diagnose o.yaml --json --db calm.db" + std::string(kBank));
  const Ran ran = diagnose_and("kill -9 $(ps -o pid= --ppid $client | head -1)", 2);
  EXPECT_EQ(ran.code, 0) << read("err.txt");
  EXPECT_EQ(read("out.json"), calm.out);
  const std::string said = read("err.txt");
  EXPECT_NE(said.find("1/", said.find("evidence")), std::string::npos) << "it began again, with what was done:\n" << said;
}

TEST_F(Gap, DiagnosesAreListedShownAndReported) {
  ASSERT_EQ(regolab("gap locate o.yaml" + std::string(kBank)).code, 0);
  EXPECT_THAT(regolab("gap ls").out, HasSubstr("1 steps done"));
  const Ran found = regolab("gap diagnose o.yaml --json" + std::string(kBank));
  ASSERT_EQ(found.code, 0) << found.err;
  const std::string id = json::parse(found.out)["provenance"]["diagnosis"];
  EXPECT_THAT(regolab("gap ls").out, HasSubstr(id.substr(0, 12) + "  made-up"));
  json shown = answer(regolab("gap show " + id.substr(0, 8) + " --json").out);
  EXPECT_GE(shown["steps"].size(), 4U);
  shown.erase("steps");
  EXPECT_EQ(shown, answer(found.out));
  EXPECT_EQ(answer(regolab("gap show o.yaml --json").out)["verdict"], "EFFECT") << "by its file";
  ASSERT_EQ(regolab("gap report " + id.substr(0, 8) + " -o r.html").code, 0);
  EXPECT_THAT(read("r.html"), HasSubstr("Gap between simulation and measurement: made-up"));
  const Ran none = regolab("gap show 0000");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("list them with `regolab gap ls`"));
  write("other.yaml", test::MadeUpGap::observations_yaml("other", 0.3, 2, 0, 0));
  EXPECT_THAT(regolab("gap report other.yaml -o s.html").err, HasSubstr("regolab gap diagnose other.yaml"));
}

TEST_F(Gap, LocateSaysWhereAndTheDiagnosisAfterItSaysTheSame) {
  const json where = json::parse(regolab("gap locate o.yaml --json" + std::string(kBank)).out);
  const json whole = json::parse(regolab("gap diagnose o.yaml --json" + std::string(kBank)).out);
  ASSERT_GT(where["where"].size(), 4U);
  EXPECT_EQ(where["where"], whole["where"]);
}

TEST_F(Gap, MeasurementsThatAreRefusedLeaveNoDatabase) {
  write("bad.yaml", spoiled(read("o.yaml"), "unit: \"1\"", "unit: \"furlong\""));
  const Ran ran = regolab("gap diagnose bad.yaml" + std::string(kBank));
  EXPECT_EQ(ran.code, 3);
  EXPECT_THAT(ran.err, HasSubstr("bad.yaml:7:"));
  EXPECT_THAT(listing(), ElementsAre("bad.yaml", "bank.csv", "kernels.json", "o.yaml"));
}

TEST_F(Gap, ABudgetNeedsItsUnitAndConfirmingNeedsSomethingToHoldOut) {
  const Ran unit = regolab("gap confirm o.yaml --budget 3" + std::string(kBank));
  EXPECT_EQ(unit.code, 2);
  EXPECT_THAT(unit.err, HasSubstr("--budget 3 (a time with its unit is wanted)"));
  std::string text = read("o.yaml");
  text.resize(text.find("- {id: sigma1_at_sigma3_2.5kPa"));
  const auto first = text.find("- {id: sigma1_peak_at_sigma3_2.5kPa");
  write("one.yaml", text.substr(0, first));
  const Ran one = regolab("gap confirm one.yaml" + std::string(kBank));
  EXPECT_EQ(one.code, 3);
  EXPECT_THAT(one.err, HasSubstr("nothing can be held out (stress tests at one confining stress only"));
}

}  // namespace
}  // namespace regolab
