#include <gmock/gmock.h>

#include "unit/include_rules/rules.h"

namespace regolab::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(IncludeRules, HoldInEverySourceFile) {
  const Survey found = survey(REGOLAB_SOURCE);
  EXPECT_GT(found.files, 100) << "too few files were read";
  EXPECT_THAT(found.breaches, IsEmpty());
}

TEST(IncludeRules, FindProtobufInTheEngine) {
  EXPECT_THAT(breaches_in("worker/dem/step.cpp", "#include <vector>\n#include \"regolab/v1/model.pb.h\"\n"),
              ElementsAre(HasSubstr("worker/dem/step.cpp:2: regolab/v1/model.pb.h (generated types")));
  EXPECT_THAT(breaches_in("scheduler/analysis/range.cpp", "#include <google/protobuf/message.h>\n"),
              ElementsAre(HasSubstr("gRPC and protobuf")));
}

TEST(IncludeRules, FindSqliteOutsideTheStore) {
  EXPECT_THAT(breaches_in("scheduler/rpc/desk.cpp", "#include <sqlite3.h>\n"), ElementsAre(HasSubstr("sqlite")));
  EXPECT_THAT(breaches_in("store/database.cpp", "#include <sqlite3.h>\n"), IsEmpty());
}

TEST(IncludeRules, FindAClientThatKnowsTheWorkerTheSchedulerOrTheStore) {
  for (const char* header : {"worker/stage/run_stage.h", "scheduler/design/design.h", "store/store.h"}) {
    EXPECT_THAT(breaches_in("client/lab.cpp", "#include \"" + std::string(header) + "\"\n"),
                ElementsAre(HasSubstr("client may not include it")));
  }
}

TEST(IncludeRules, FindAnArrowThatPointsUpwards) {
  EXPECT_THAT(breaches_in("worker/dem/step.cpp", "#include \"worker/protocol/settle.h\"\n"),
              ElementsAre(HasSubstr("worker/dem may not")));
  EXPECT_THAT(breaches_in("worker/output/job_run.cpp", "#include \"worker/dem/world.h\"\n"),
              ElementsAre(HasSubstr("worker/output may not")));
  EXPECT_THAT(breaches_in("proto/vocab/units.h", "#include \"input/job_file.h\"\n"),
              ElementsAre(HasSubstr("proto/vocab may not")));
}

TEST(IncludeRules, FindAClockAndLogInTheCore) {
  EXPECT_THAT(breaches_in("worker/protocol/settle.cpp", "#include <chrono>\n"), ElementsAre(HasSubstr("a clock")));
  EXPECT_THAT(breaches_in("scheduler/queue/lease.cpp", "  now = std::chrono::system_clock::now();\n"),
              ElementsAre(HasSubstr("a clock")));
  EXPECT_THAT(breaches_in("worker/dem/step.cpp", "#include <spdlog/spdlog.h>\n"), ElementsAre(HasSubstr("spdlog")));
  EXPECT_THAT(breaches_in("worker/dem/step.cpp", "// no steady_clock here\n"), IsEmpty()) << "comments may speak of it";
}

TEST(IncludeRules, FindPrintingInALibraryButNotTextMaking) {
  EXPECT_THAT(breaches_in("store/store.cpp", "  std::printf(\"x\");\n"), ElementsAre(HasSubstr("printing")));
  EXPECT_THAT(breaches_in("store/store.cpp", "  std::snprintf(b, 3, \"x\");\n"), IsEmpty());
}

TEST(IncludeRules, AskForARuleWhereAFolderHasNone) {
  EXPECT_THAT(breaches_in("viewer/page.cpp", "#include \"vocab/units.h\"\n"), ElementsAre(HasSubstr("add one")));
}

}  // namespace
}  // namespace regolab::test
