#include "scheduler/design/table_csv.h"

#include <gtest/gtest.h>

#include "support/diagnostics.h"
#include "vocab/units.h"

namespace regolab {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing_support::at;

struct Table {
  std::vector<FactorLevels> factors;
  std::vector<std::vector<int>> rows;
  std::vector<Diagnostic> diagnostics;
};

Table read(std::string_view csv) {
  Table table;
  Report report("t.csv", csv);
  table.rows = read_table(csv, DampingUnit::kAbsolute, table.factors, report);
  table.diagnostics = report.take();
  return table;
}

TEST(TableCsv, ReadsUnitsFromTheHeader) {
  const Table table = read(
      "point,theta_F_deg,K_N (N/m),eta_N_N_s_per_m,L_S [cm],gravity_m_per_s2,N_E,rotation\n"
      "1,20,5e4,0.5,1,1.63,6,none\n# a comment\n2,0.1,1e5,1,2 cm,9.8,mixture,xz\n");
  EXPECT_THAT(table.diagnostics, IsEmpty());
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre(1, 0, 0, 0, 0, 0, 0), ElementsAre(0, 1, 1, 1, 1, 1, 1)));
  ASSERT_EQ(table.factors.size(), 7u);
  EXPECT_EQ(table.factors[0].field.name, "theta_F");
  EXPECT_DOUBLE_EQ(table.factors[0].values[1], 20 * kDegree);
  EXPECT_DOUBLE_EQ(table.factors[3].values[0], 0.01);
  EXPECT_THAT(labels_of(table.factors[5]), ElementsAre("6", "mixture"));
}

TEST(TableCsv, TellsEveryProblemAtItsCell) {
  EXPECT_THAT(read("K_N_N_per_m,thet_F_deg\n1e5,20\n5e4,40\n").diagnostics,
              ElementsAre(at(1, 13, "unknown column 'thet_F_deg'")));
  EXPECT_THAT(read("K_N_N_per_m,K_N (N/m)\n1e5,1\n5e4,2\n").diagnostics, ElementsAre(at(1, 13, "duplicate column")));
  EXPECT_THAT(read("K_N_N_per_m,N_E\n1e5,2\n-5,5\n").diagnostics,
              ElementsAre(at(3, 1, "row 2, K_N: -5 (must be between"), at(3, 4, "'5' is no elements")));
  EXPECT_THAT(read("K_N_N_per_m,N_E\n1e5,2\n5e4\n").diagnostics,
              ElementsAre(at(3, 1, "row has 1 cells (the header has 2)")));
  EXPECT_THAT(read("K_N_N,N_E\n1e5,2\n5e4,4\n").diagnostics, ElementsAre(at(2, 1, "is a force"), at(3, 1, "is a force")));
  EXPECT_THAT(read("K_N,N_E\n1e5,2\n5e4,4\n").diagnostics, ElementsAre(at(2, 1, "has no unit"), at(3, 1, "has no unit")));
  EXPECT_THAT(read("point,N_E\n1,2\n3,4\n").diagnostics,
              ElementsAre(at(3, 1, "point '3' (points count 1, 2, 3, ...) write 2")));
  EXPECT_THAT(read("N_E,rotation\n2,x\n2,z\n").diagnostics, ElementsAre(at(1, 1, "column 'N_E' has the same value in every row")));
  EXPECT_THAT(read("N_E\n").diagnostics, ElementsAre(at(0, 0, "table has 0 rows below its header")));
  EXPECT_THAT(read("").diagnostics, ElementsAre(at(0, 0, "table has 0 rows")));
  EXPECT_THAT(read("N_E\n2\n\xFF\n").diagnostics, ElementsAre(at(0, 0, "not a text file")));
}

TEST(TableCsv, OneRowIsOneMaterial) {
  const auto found = read("N_E,theta_F_deg\n4,30\n");
  EXPECT_TRUE(found.diagnostics.empty());
}

}  // namespace
}  // namespace regolab
