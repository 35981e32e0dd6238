#include "scheduler/analysis/article.h"
#include "scheduler/analysis/range.h"
#include <gtest/gtest.h>
#include <cstdio>
using namespace regolab; using namespace regolab::analysis;
TEST(Scratch, Show) {
  auto c = check_article();
  for (auto& e : c.entries) if (!e.agrees || e.table!="Table 5") std::printf("%s %-40s %8.3f %9.4f %s %s\n", e.table.c_str(), e.entry.c_str(), e.printed, e.recomputed, e.agrees ? "ok" : "NO", e.explanation.c_str());
  for (auto& f : c.findings) std::printf("* %s\n", f.c_str());
  auto r = analyse_ranges(article_results(), "");
  for (auto& a : *r) { std::printf("%s [%s] n %d mean %.3f s %.4f df %d\n", a.response.c_str(), a.unit.c_str(), a.runs_used, a.mean, a.residual_standard_deviation, a.error_degrees_of_freedom);
    for (auto& f : a.factors) { std::printf("   %-9s R %7.3f rank %d hi %s lo %s F %.2f p %.4f loo %.3f..%.3f lean %d %s %s |", f.name.c_str(), f.range, f.rank, f.highest_level.c_str(), f.lowest_level.c_str(), f.f.value_or(-1), f.p.value_or(-1), f.leave_one_out_range_min, f.leave_one_out_range_max, f.leaning_on_point, f.fragile ? "FRAGILE" : "", f.fragile_why.c_str());
      for (auto& l : f.levels) std::printf(" %s: %.3f+-%.3f", l.label.c_str(), l.mean, l.half_width_95.value_or(0)); 
 std::printf("\n"); }
    for (auto& n : a.notes) std::printf("   note %s\n", n.c_str()); }
}
