/// The service of gap diagnosis over a real socket.
#include <algorithm>
#include <cmath>

#include "scheduler/gap/bank.h"
#include "unit/rpc/service_fixture.h"

namespace regolab {
namespace {

using ServiceTest = test::ServiceTest;
using test::l4_yaml;
using testing::HasSubstr;

TEST_F(ServiceTest, ABankHasARowForEachPointAndSeed) {
  const auto submitted = client->submit(l4_yaml(2));
  {
    const Worker worker{*this, "w", {.duration_s = 0.02}};
    client->wait(submitted.experiment());
  }
  v1::BankRequest request;
  request.add_experiments(submitted.experiment());
  v1::BankReply reply;
  const auto status = client->call(*client->gaps, &v1::Gaps::Stub::Bank, request, &reply);
  ASSERT_TRUE(status.ok()) << status.error_message();
  EXPECT_EQ(reply.rows(), 10U) << "8 runs, and two of them again under a wrong grain density";
  const auto bank = gap::read_bank("bank.csv", reply.csv());
  ASSERT_TRUE(bank.ok()) << to_text(bank.diagnostics.front());
  ASSERT_EQ(bank.value->rows.size(), 10U);
  const auto density = bank.value->input("grain_density");
  ASSERT_TRUE(density);
  EXPECT_EQ(std::ranges::count_if(bank.value->rows, [&](const auto& row) { return row.inputs[*density] != 0; }), 2);
  ASSERT_TRUE(bank.value->input("theta_F") && bank.value->input("N_E") && bank.value->feature("sigma1_ratio_2.5"));
  for (const auto& row : bank.value->rows) {
    const double friction = row.inputs[*bank.value->input("theta_F")];
    EXPECT_NEAR(row.features[*bank.value->feature("repose_angle")], friction, 0.011) << "the fake measures theta_F as its slope";
    EXPECT_EQ(row.inputs[*bank.value->input("particles")], 120);
    const double ratio = std::exp(row.features[*bank.value->feature("sigma1_ratio_2.5")]);
    EXPECT_TRUE(ratio > 2 && ratio < 3) << ratio;
  }
  request.add_experiments("none");
  EXPECT_EQ(client->call(*client->gaps, &v1::Gaps::Stub::Bank, request, &reply).error_code(), grpc::StatusCode::NOT_FOUND);
}

TEST_F(ServiceTest, MeasurementsAreReadOrRefusedWithTheirPlaces) {
  v1::ImportRequest request;
  request.set_file_name("o.yaml");
  request.set_content("format: observations/1\ncase: c\nobservables:\n- {id: bulk_density, value: 1.6, unit: g/cm3, standard_error: 0.016}\n");
  request.set_want_file(true);
  v1::ImportReply reply;
  ASSERT_TRUE(client->call(*client->gaps, &v1::Gaps::Stub::Import, request, &reply).ok());
  ASSERT_EQ(reply.features_size(), 1);
  EXPECT_EQ(reply.features(0).unit(), "g/cm3");
  EXPECT_NEAR(reply.features(0).shown(), 1.6, 1e-12);
  EXPECT_NEAR(reply.features(0).value(), 1600, 1e-9);
  EXPECT_TRUE(reply.few());
  EXPECT_THAT(reply.file(), HasSubstr("observations/1"));

  request.set_content("format: observations/1\ncase: c\nobservables:\n- {id: bulk_density, value: 1.6, unit: kPa, standard_error: -1}\n");
  ASSERT_TRUE(client->call(*client->gaps, &v1::Gaps::Stub::Import, request, &reply).ok());
  ASSERT_EQ(reply.diagnostics_size(), 2);
  EXPECT_EQ(reply.diagnostics(0).line(), 4U);

  request.set_content("format: observations/1\ncase: gro\xDF\n");
  ASSERT_TRUE(client->call(*client->gaps, &v1::Gaps::Stub::Import, request, &reply).ok()) << "a line that is not UTF-8 must not break the wire";
  ASSERT_EQ(reply.diagnostics_size(), 1);
  EXPECT_EQ(reply.diagnostics(0).line(), 2U);
  EXPECT_THAT(reply.diagnostics(0).text(), HasSubstr("not a text file"));

  request.set_content(std::string((16 << 20) + 1, '#'));
  ASSERT_TRUE(client->call(*client->gaps, &v1::Gaps::Stub::Import, request, &reply).ok());
  ASSERT_EQ(reply.diagnostics_size(), 1);
  EXPECT_THAT(reply.diagnostics(0).text(), HasSubstr("the limit is 16777216"));
  request.set_content(std::string(19 << 20, '#'));
  EXPECT_EQ(client->call(*client->gaps, &v1::Gaps::Stub::Import, request, &reply).error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
}

}  // namespace
}  // namespace regolab
