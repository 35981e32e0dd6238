/// Runs the built programs in a folder of their own and keeps what they say.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace regolab {

struct Ran {
  int code = -1;
  std::string out;
  std::string err;
};

class Programs : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// `line` is a shell command; $regolab, $scheduler and $worker are the programs. Runs in folder().
  Ran shell(const std::string& line);
  /// "regolab" and `words`.
  Ran regolab(const std::string& words) { return shell("$regolab " + words); }

  std::string write(const std::string& name, const std::string& text);
  std::string read(const std::string& name) const;
  const std::filesystem::path& folder() const { return folder_; }
  /// Files and folders there now, by name.
  std::vector<std::string> listing() const;

 private:
  std::filesystem::path folder_;
};

/// A study of four points that is right; tests spoil one thing of it.
std::string good_design();

/// `text` with the first `from` replaced. A test that spoils nothing would prove nothing, so `from` must be there.
std::string spoiled(std::string text, const std::string& from, const std::string& to);

}  // namespace regolab
