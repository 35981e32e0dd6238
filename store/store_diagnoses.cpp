/// Diagnoses: written by the store, read by a reader.
#include "store/reader.h"
#include "store/store.h"

namespace regolab {
namespace {

#define REGOLAB_DIAGNOSIS_COLUMNS "id, case_name, created_ms, ended_ms, observations, bank, kernels, method, options, held_out, result, shrinkage"

DiagnosisRecord record_of(const Statement& s) {
  DiagnosisRecord r{.id = s.text(0), .case_name = s.text(1), .created_ms = s.integer(2), .ended_ms = {}, .observations = s.text(4), .bank = s.text(5),
                    .kernels = s.text(6), .method = s.text(7), .options = s.text(8), .held_out = s.text(9), .measurements = {}, .result = s.text(10), .shrinkage = s.text(11)};
  if (!s.null(3)) r.ended_ms = s.integer(3);
  return r;
}

Error no_such_diagnosis(const std::string& id) {
  return {Code::kNotFound, "diagnosis '" + id + "' is not known here (not in this database) list them with `regolab gap ls`"};
}

}  // namespace

Result<void> Store::add_diagnosis(const DiagnosisRecord& r) {
  return db_.prepare("INSERT INTO diagnosis VALUES (?, ?, ?, NULL, ?, ?, ?, ?, ?, ?, ?, '', '') ON CONFLICT (id) DO NOTHING")
      .bind(r.id)
      .bind(r.case_name)
      .bind(r.created_ms)
      .bind(r.observations)
      .bind(r.bank)
      .bind(r.kernels)
      .bind(r.method)
      .bind(r.options)
      .bind(r.held_out)
      .bind_blob(r.measurements)
      .run("store a diagnosis");
}

Result<void> Store::add_diagnosis_step(const std::string& diagnosis, const DiagnosisStep& step) {
  return db_.prepare("INSERT INTO diagnosis_step VALUES (?, ?, ?, ?) ON CONFLICT DO NOTHING")
      .bind(diagnosis)
      .bind(step.name)
      .bind(step.done_ms)
      .bind_blob(step.result)
      .run("store a step of a diagnosis");
}

Result<void> Store::end_diagnosis(const std::string& id, const std::string& result, std::int64_t unix_ms) {
  return db_.prepare("UPDATE diagnosis SET result = ?, ended_ms = ? WHERE id = ? AND ended_ms IS NULL").bind(result).bind(unix_ms).bind(id).run("end a diagnosis");
}

Result<void> Store::set_shrinkage(const std::string& id, const std::string& shrinkage) {
  return db_.prepare("UPDATE diagnosis SET shrinkage = ? WHERE id = ?").bind(shrinkage).bind(id).run("store a shrinkage");
}

Result<std::vector<DiagnosisRecord>> Reader::diagnoses() {
  std::vector<DiagnosisRecord> all;
  Statement s = db_.prepare("SELECT " REGOLAB_DIAGNOSIS_COLUMNS " FROM diagnosis ORDER BY created_ms DESC, id");
  while (s.step()) all.push_back(record_of(s));
  if (auto end = s.end("read the diagnoses"); !end.ok()) return end.error();
  return all;
}

Result<DiagnosisRecord> Reader::diagnosis(const std::string& id) {
  Statement s = db_.prepare("SELECT " REGOLAB_DIAGNOSIS_COLUMNS ", measurements FROM diagnosis WHERE substr(id, 1, length(?1)) = ?1 ORDER BY id");
  if (!s.bind(id).step()) {
    if (auto end = s.end("read a diagnosis"); !end.ok()) return end.error();
    return no_such_diagnosis(id);
  }
  DiagnosisRecord found = record_of(s);
  found.measurements = s.text(12);
  if (s.step()) return invalid("diagnosis '" + id + "' (several start so) give more digits, see `regolab gap ls`");
  return found;
}

Result<std::vector<DiagnosisStep>> Reader::diagnosis_steps(const std::string& id) {
  std::vector<DiagnosisStep> steps;
  Statement s = db_.prepare("SELECT name, done_ms, result FROM diagnosis_step WHERE diagnosis = ? ORDER BY rowid");
  for (s.bind(id); s.step();) steps.push_back({s.text(0), s.integer(1), s.text(2)});
  if (auto end = s.end("read the steps of a diagnosis"); !end.ok()) return end.error();
  return steps;
}

}  // namespace regolab
