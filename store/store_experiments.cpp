#include "store/store.h"

namespace regolab {

Result<void> Store::add_model(const ModelRecord& r) {
  return db_.prepare("INSERT INTO model VALUES (?, ?, ?, ?) ON CONFLICT (id) DO UPDATE SET created_ms = excluded.created_ms")
      .bind(r.id)
      .bind(r.name)
      .bind(r.created_ms)
      .bind(r.file)
      .run("store a model");
}

Result<void> Store::add_experiment(const ExperimentRecord& r) {
  auto done = db_.prepare("INSERT INTO experiment VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, NULL)")
                  .bind(static_cast<std::uint64_t>(r.id))
                  .bind(r.label)
                  .bind(r.name)
                  .bind(r.request_id)
                  .bind(r.digest)
                  .bind(r.design_yaml)
                  .bind(r.file_name)
                  .bind(r.array)
                  .bind(r.summary)
                  .bind(name_of(r.state))
                  .bind(r.created_ms)
                  .run("store the experiment");
  const auto id = static_cast<std::uint64_t>(r.id);
  for (const auto& [name, bytes] : r.attachments) {
    if (!done.ok()) return done;
    done = db_.prepare("INSERT INTO design_file VALUES (?, ?, ?)").bind(id).bind(name).bind_blob(bytes).run("store a file");
  }
  for (std::size_t f = 0; done.ok() && f < r.factors.size(); ++f) {
    const TableFactor& factor = r.factors[f];
    done = db_.prepare("INSERT INTO factor VALUES (?, ?, ?, ?)")
               .bind(id)
               .bind(f)
               .bind(factor.name)
               .bind(factor.unit)
               .run("store a factor");
    for (std::size_t l = 0; done.ok() && l < factor.levels.size(); ++l) {
      done = db_.prepare("INSERT INTO level VALUES (?, ?, ?, ?)")
                 .bind(id)
                 .bind(f)
                 .bind(l)
                 .bind(factor.levels[l])
                 .run("store a level");
    }
  }
  for (std::size_t p = 0; p < r.levels.size(); ++p) {
    for (std::size_t f = 0; done.ok() && f < r.levels[p].size(); ++f) {
      done = db_.prepare("INSERT INTO point_level VALUES (?, ?, ?, ?)")
                 .bind(id)
                 .bind(p + 1)
                 .bind(f)
                 .bind(r.levels[p][f])
                 .run("store a point");
    }
  }
  for (std::size_t n = 0; done.ok() && n < r.responses.size(); ++n) {
    const ResponseRecord& response = r.responses[n];
    done = db_.prepare("INSERT INTO response VALUES (?, ?, ?, ?, ?)")
               .bind(id)
               .bind(n)
               .bind(response.id)
               .bind(response.unit)
               .bind(name_of(response.stage))
               .run("store a response");
  }
  return done;
}

Result<void> Store::change_experiment(ExperimentId id, ExperimentState state, std::int64_t unix_ms) {
  Statement statement = db_.prepare("UPDATE experiment SET state = ?, ended_ms = ? WHERE id = ?");
  statement.bind(name_of(state));
  if (state == ExperimentState::kRunning)
    statement.bind_null();
  else
    statement.bind(unix_ms);
  return statement.bind(static_cast<std::uint64_t>(id)).run("change an experiment");
}

Result<void> Store::add_event(ExperimentId id, std::uint64_t seq, std::int64_t unix_ms, const std::string& text) {
  return db_.prepare("INSERT INTO event VALUES (?, ?, ?, ?)")
      .bind(static_cast<std::uint64_t>(id))
      .bind(seq)
      .bind(unix_ms)
      .bind(text)
      .run("store an event");
}

Result<std::vector<EventRecord>> Store::events(ExperimentId id, std::uint64_t from_seq, int limit) {
  std::vector<EventRecord> events;
  Statement s = db_.prepare("SELECT seq, text FROM event WHERE experiment = ? AND seq >= ? ORDER BY seq LIMIT ?");
  s.bind(static_cast<std::uint64_t>(id)).bind(from_seq).bind(limit);
  while (s.step()) events.push_back({static_cast<std::uint64_t>(s.integer(0)), s.text(1)});
  if (auto end = s.end("read events"); !end.ok()) return end.error();
  return events;
}

}  // namespace regolab
