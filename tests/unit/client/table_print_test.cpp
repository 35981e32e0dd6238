#include "client/table_print.h"

#include <gtest/gtest.h>

namespace regolab::client {
namespace {

TEST(TablePrint, AlignsColumnsAndLeavesNoTrailingBlanks) {
  Table table({{"name", "", Align::kLeft}, {"value", "kPa"}});
  table.add({"a", "1.25"});
  table.add({"longer", "10"});
  EXPECT_EQ(table.text(),
            "name    value\n"
            "          kPa\n"
            "------  -----\n"
            "a        1.25\n"
            "longer     10\n");
}

TEST(TablePrint, LeavesOutTheUnitLineWhenThereAreNoUnits) {
  Table table({{"a"}, {"b"}});
  table.add({"1", "2"});
  EXPECT_EQ(table.text(2), "  a  b\n  -  -\n  1  2\n");
}

TEST(TablePrint, CountsLettersNotBytes) {
  EXPECT_EQ(display_width("3.5 ±1.5"), 8);
  Table table({{"R"}, {"x"}});
  table.add({"3.5 ±1.5", "1"});
  table.add({"12345678", "1"});
  EXPECT_EQ(table.text(), "       R  x\n--------  -\n3.5 ±1.5  1\n12345678  1\n");
}

}  // namespace
}  // namespace regolab::client
