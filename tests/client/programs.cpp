#include "tests/client/programs.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace regolab {

namespace fs = std::filesystem;

void Programs::SetUp() {
  std::string pattern = fs::temp_directory_path() / "regolab-test-XXXXXX";
  folder_ = mkdtemp(pattern.data());
  unsetenv("REGOLAB_SERVER");
  setenv("regolab", REGOLAB_BIN "/regolab", 1);
  setenv("scheduler", REGOLAB_BIN "/regolab-scheduler", 1);
  setenv("worker", REGOLAB_BIN "/regolab-worker", 1);
}

void Programs::TearDown() { fs::remove_all(folder_); }

Ran Programs::shell(const std::string& line) {
  const fs::path out = folder_.string() + ".out";
  const fs::path err = folder_.string() + ".err";
  const std::string command =
      "cd " + folder_.string() + " && { " + line + "\n} >" + out.string() + " 2>" + err.string() + " </dev/null";
  const int status = std::system(command.c_str());
  const auto take = [](const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    fs::remove(path);
    return text;
  };
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .out = take(out), .err = take(err)};
}

std::string Programs::write(const std::string& name, const std::string& text) {
  std::ofstream(folder_ / name, std::ios::binary) << text;
  return name;
}

std::string Programs::read(const std::string& name) const {
  std::ifstream file(folder_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> Programs::listing() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string good_design() {
  return R"(name: four
profile: quick
particles: 120
seeds: 1
factors:
  theta_F: [5 degree, 40 degree]
  N_E: [2, 6]
  L_S: [1 cm, 2 cm]
fixed:
  K_N: 5e4 N/m
  eta_N: 0.5 N s/m
  K_T: 5e4 N/m
  eta_T: 0.5 N s/m
  rotation: xz
array: L4
tests: [settle]
)";
}

std::string spoiled(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace regolab
