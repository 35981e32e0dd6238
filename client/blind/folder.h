/// The folder of a set of blind cases: what was committed to, what was handed in, what was answered.
///   set.json            how many cases, of how many specimens; "development" where it was drawn from a known seed
///   commitments         SHA-256 of each truth, before any run; `cd truths && sha256sum -c ../commitments` once they are revealed
///   sealed/ID           the truths under a key that is not here
///   cases/ID.yaml       what an experimenter hands in
///   cases/ID.answer.json, answers   the answers, and SHA-256 of each; `cd cases && sha256sum -c ../answers`
///   truths/ID.json, record.csv, score.json, score.txt   after the reveal
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "client/outcome.h"

namespace regolab::client {

struct BlindSet {
  unsigned cases = 96, nulls = 60, specimens = 3;
  std::optional<std::uint64_t> seed;  ///< of a development set
};

/// A line of `commitments` or `answers`.
struct Digest {
  std::string id;
  std::string sha256;
};

class BlindFolder {
 public:
  explicit BlindFolder(std::filesystem::path path) : path_(std::move(path)) {}
  ~BlindFolder();
  BlindFolder(const BlindFolder&) = delete;
  BlindFolder& operator=(const BlindFolder&) = delete;

  /// Nobody else works on it until this object ends. Makes the folder where `make` is set.
  Outcome lock(bool make);

  bool drawn() const;  ///< a set stands here: commitments and all truths under seal
  /// Sealed truths first, then commitments, the set last: a kill leaves either a whole set or none.
  Outcome write_set(const BlindSet& set, const std::vector<Digest>& commitments, const std::vector<std::pair<std::string, std::string>>& sealed);
  /// What stands here, with the list's own digest checked. REQUIRES: lock.
  Outcome read();

  const BlindSet& set() const { return set_; }
  const std::vector<Digest>& commitments() const { return commitments_; }
  const std::vector<Digest>& answers() const { return answers_; }
  std::string list_digest() const;  ///< over all commitments: what to publish
  const Digest* answer_of(const std::string& id) const;

  std::filesystem::path sealed_file(const std::string& id) const { return path_ / "sealed" / id; }
  std::filesystem::path case_file(const std::string& id) const { return path_ / "cases" / (id + ".yaml"); }
  std::filesystem::path answer_file(const std::string& id) const { return path_ / "cases" / (id + ".answer.json"); }
  std::filesystem::path shrinkage_file(const std::string& id) const { return path_ / "cases" / (id + ".shrinkage.json"); }
  std::filesystem::path truth_file(const std::string& id) const { return path_ / "truths" / (id + ".json"); }
  const std::filesystem::path& path() const { return path_; }

  /// The answer, then its line in `answers`: what has no line does not count.
  Outcome add_answer(const std::string& id, const std::string& text);
  /// Every committed answer is there, unchanged.
  Outcome check_answers() const;

 private:
  std::filesystem::path path_;
  int lock_ = -1;
  BlindSet set_;
  std::vector<Digest> commitments_, answers_;
  bool torn_ = false;  ///< `answers` ends in half a line
};

/// True when `inner` lies in `folder` or is it.
bool lies_in(const std::filesystem::path& inner, const std::filesystem::path& folder);

}  // namespace regolab::client
