#include "input/job_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <sstream>
using namespace regolab;
TEST(Scratch, Show) {
  const char* files[] = {"", "profile: quik\nseeed: 1\nparticles: 1000000000\nmicro: {theta_F: 20, K_N: 5e4 N, K_N: 5e4 N/m, eta_N: .nan N.s/m, K_T: -7.5e4 N/m, L_S: 1e999 cm, N_E: 5, rotaton: none}\ntests: [settle, reposs]\nstress: {sigma3: [1.25 kPa, 5 s, 1250 Pa]}\n",
  "micro: {theta_F: 20 degree, K_N: 1e5", "a: [1, 2", std::getenv("JOB") ? std::getenv("JOB") : "x"};
  for (auto f : files) { auto r = read_job(f, "job.yaml"); for (auto& d : r.diagnostics) std::cout << to_text(d) << "\n"; std::cout << "-----\n"; }
  std::ifstream in(REGOLAB_SOURCE "/client/examples/job.yaml"); std::stringstream s; s << in.rdbuf();
  auto r = read_job(s.str(), "job.yaml"); for (auto& d : r.diagnostics) std::cout << to_text(d) << "\n"; ASSERT_TRUE(r.ok());
  for (std::string unit : {"[", "{", "- ", "? ", "[[", "a: {", "{a: ", "!!x ", "&a ", "\"", "'", "#", "|\n", "%", "---\n", "a:\n ", "*a ", "[*a,", "{? ", "- - ", "x: y: ", "\t", "...\n", ">", "a: b\n"}) {
    std::string bomb; while (bomb.size() < (1u << 20) - 10) bomb += unit;
    auto t = std::chrono::steady_clock::now(); auto q = read_job(bomb, "bomb");
    std::cout << unit << " " << q.diagnostics.size() << " " << std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count() << " s " << (q.diagnostics.empty() ? "" : q.diagnostics[0].text) << std::endl;
  }
}
