#include "scheduler/design/design_file.h"
#include "scheduler/design/expand.h"
#include <gtest/gtest.h>
#include <fstream>
#include <iostream>
#include <sstream>
using namespace regolab;
std::string slurp(std::string p){std::ifstream in(p); std::stringstream s; s<<in.rdbuf(); return s.str();}
TEST(Scratch, Show) {
  for (std::string f : {"article-l32", "small-l4"}) {
    auto r = read_design({slurp(std::string(REGOLAB_SOURCE "/client/examples/") + f + ".yaml"), f + ".yaml", {}}, {});
    for (auto& d : r.diagnostics) std::cout << to_text(d) << "\n";
    if (!r.ok()) continue;
    auto& d = *r.value; std::cout << d.name << " " << d.array << " " << d.points.size() << " strength " << d.quality.strength << " df " << d.quality.error_degrees_of_freedom << " stages " << expand(d).size() << "\n";
    for (auto& l : factor_columns(d)) std::cout << "  " << l << "\n";
    for (auto& l : d.notes) std::cout << "  " << l << "\n";
    for (auto& [k, v] : d.fixed) std::cout << "  " << k << " = " << v << "\n";
    for (auto& f2 : d.factors) { std::cout << "  " << f2.name << " [" << f2.unit << "]"; for (auto& x : f2.labels) std::cout << " " << x; std::cout << "\n"; }
    for (auto& t : responses_of(d)) std::cout << t.id << " " << t.unit << ", ";
 std::cout << "\n";
  }
}
