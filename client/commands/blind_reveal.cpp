#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "client/blind/key_file.h"
#include "client/blind/sealed_truths.h"
#include "client/commands/commands.h"
#include "client/commands/gap.h"
#include "client/file_read.h"
#include "client/file_write.h"
#include "client/json_view.h"
#include "client/session.h"
#include "digest/sha256.h"

namespace regolab::client {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLargestCase = 16 << 20;  // [bytes]

Outcome read(const fs::path& file, std::string& text) { return read_whole_file(file, kLargestCase, "a part of a blind case", text); }

/// All that scoring needs of one answered case. The file that was answered is the file that stands there now.
Outcome gather(const BlindFolder& folder, const Digest& commitment, const std::string& key, pb::BlindScoreRequest& out) {
  std::string truth, answer, observations, shrinkage;
  if (auto got = open_truth(folder, commitment, key, truth); !got.ok()) return got;
  if (auto got = read(folder.answer_file(commitment.id), answer); !got.ok()) return got;
  if (auto got = read(folder.case_file(commitment.id), observations); !got.ok()) return got;
  const auto j = nlohmann::json::parse(answer, nullptr, false);
  if (!j.is_object() || !j.contains("provenance") || j["provenance"].value("measurements", "") != sha256_hex(observations)) {
    return failed(Exit::kInvalidInput, fmt::format("{} was changed after it was answered (the answer names another SHA-256) restore it",
                                                   folder.case_file(commitment.id).string()));
  }
  std::error_code ignored;
  if (fs::exists(folder.shrinkage_file(commitment.id), ignored)) {
    if (auto got = read(folder.shrinkage_file(commitment.id), shrinkage); !got.ok()) return got;
  }
  out.set_truth(truth), out.set_answer(answer), out.set_observations(observations), out.set_shrinkage(shrinkage);
  return done();
}

Outcome write_truths(const BlindFolder& folder, const std::vector<std::string>& ids, const std::vector<pb::BlindScoreRequest>& messages) {
  std::error_code error;
  fs::create_directories(folder.path() / "truths", error);
  if (error) return failed(Exit::kInternal, fmt::format("cannot make {} ({}) make room", (folder.path() / "truths").string(), error.message()));
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (auto written = write_file(folder.truth_file(ids[k]), messages[k + 1].truth()); !written.ok()) return written;  // [0] is the bank
  }
  return done();
}

Outcome write_record(const BlindFolder& folder, const pb::BlindScoreReply& reply) {
  if (auto written = write_file(folder.path() / "record.csv", reply.record_csv()); !written.ok()) return written;
  if (auto written = write_file(folder.path() / "score.json", reply.score_json()); !written.ok()) return written;
  return write_file(folder.path() / "score.txt", reply.text());
}

}  // namespace

Outcome blind_reveal(const Arguments& arguments, Console& console) {
  BlindFolder folder(arguments.folder);
  if (auto locked = folder.lock(false); !locked.ok()) return locked;
  if (auto got = folder.read(); !got.ok()) return got;
  if (auto whole = folder.check_answers(); !whole.ok()) return whole;
  const std::size_t missing = folder.commitments().size() - folder.answers().size();
  if (folder.answers().empty() || (missing > 0 && !arguments.partial)) {
    return failed(Exit::kUsage,
                  fmt::format("{} of {} cases have no answer (once truths lie open, nobody can give one) answer them: regolab gap blind solve {}{}",
                              missing, folder.commitments().size(), arguments.folder,
                              folder.answers().empty() ? "" : "; or --partial, which is then said in the record"));
  }
  std::string key;
  const fs::path key_file = arguments.key.empty() ? default_key_file(arguments.folder) : fs::path(arguments.key);
  if (auto got = read_key(key_file, arguments.folder, key); !got.ok()) return got;
  pb::DiagnoseRequest bank;
  if (auto got = read_bank_files(arguments, bank); !got.ok()) return got;
  std::vector<pb::BlindScoreRequest> messages(1);
  messages[0].set_bank_csv(bank.bank_csv()), messages[0].set_bank_name(bank.bank_name()), messages[0].set_kernels_json(bank.kernels_json());
  messages[0].set_missing(static_cast<std::uint32_t>(missing));
  std::vector<std::string> ids;
  for (const Digest& commitment : folder.commitments()) {
    if (!folder.answer_of(commitment.id)) continue;
    ids.push_back(commitment.id);
    if (auto got = gather(folder, commitment, key, messages.emplace_back()); !got.ok()) return got;
  }
  Session session;
  if (auto opened = open_session(arguments, Need::kScratch, session); !opened.ok()) return opened;
  pb::BlindScoreReply reply;
  if (auto got = session.lab->score_blind(messages, reply); !got.ok()) return session.explain(got);
  for (const std::string& warning : reply.warnings()) console.err << "warning: " << warning << "\n";
  if (auto written = write_truths(folder, ids, messages); !written.ok()) return written;
  if (auto written = write_record(folder, reply); !written.ok()) return written;
  console.out << (arguments.json ? reply.score_json() : reply.text()) << std::flush;
  console.err << fmt::format("\nevery commitment held ({} truths, {} answers). truths, record.csv, score.json, score.txt are in {}\n", ids.size(),
                             folder.answers().size(), arguments.folder);
  return done();
}

}  // namespace regolab::client
