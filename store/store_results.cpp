#include "store/exact.h"
#include "store/store.h"

namespace regolab {

Result<void> Store::accept_result(const Acceptance& a, const StageResult& result) {
  const auto job = static_cast<std::uint64_t>(a.job);
  const bool current = db_.prepare("SELECT 1 FROM job WHERE id = ? AND lease_token = ? AND state = 'leased'")
                           .bind(job)
                           .bind(static_cast<std::uint64_t>(a.token))
                           .step();
  if (!current) return Error{Code::kAborted, "result of job " + std::to_string(job) + " refused (its lease has ended)"};
  auto done = db_.prepare("INSERT INTO result VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
                  .bind(job)
                  .bind(static_cast<std::uint64_t>(a.token))
                  .bind(static_cast<int>(result.end))
                  .bind(name_of(result.end))
                  .bind(result.reason)
                  .bind(a.wall_s)
                  .bind(a.steps)
                  .bind(a.unix_ms)
                  .run("store a result");
  if (done.ok()) done = insert_measurements(a.job, "response", result.measurements);
  if (done.ok()) done = insert_measurements(a.job, "numerics", result.numerics);
  for (std::size_t n = 0; done.ok() && n < result.curves.size(); ++n) {
    done = insert_curve(a.job, static_cast<int>(n), result.curves[n]);
  }
  return done;
}

Result<void> Store::insert_measurements(JobId job, const char* role, const std::vector<Measurement>& list) {
  for (std::size_t n = 0; n < list.size(); ++n) {
    const Measurement& m = list[n];
    Statement s = db_.prepare("INSERT INTO measurement VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    s.bind(static_cast<std::uint64_t>(job)).bind(std::string_view(role)).bind(n).bind(m.id);
    bind_exact(s, m.value);
    s.bind(m.unit);
    if (m.standard_error)
      bind_exact(s, *m.standard_error);
    else
      s.bind_null().bind_null();
    if (auto done = s.bind(m.definition).run("store a measurement"); !done.ok()) return done;
  }
  return {};
}

Result<void> Store::insert_curve(JobId job, int n, const Curve& curve) {
  const auto id = static_cast<std::uint64_t>(job);
  auto done = db_.prepare("INSERT INTO curve VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
                  .bind(id)
                  .bind(n)
                  .bind(curve.id)
                  .bind(curve.test)
                  .bind(curve.x_name)
                  .bind(curve.x_unit)
                  .bind(curve.y_name)
                  .bind(curve.y_unit)
                  .run("store a curve");
  for (std::size_t i = 0; done.ok() && i < std::max(curve.x.size(), curve.y.size()); ++i) {
    Statement s = db_.prepare("INSERT INTO curve_point VALUES (?, ?, ?, ?, ?, ?, ?)");
    s.bind(id).bind(n).bind(i);
    if (i < curve.x.size())
      bind_exact(s, curve.x[i]);
    else
      s.bind_null().bind_null();
    if (i < curve.y.size())
      bind_exact(s, curve.y[i]);
    else
      s.bind_null().bind_null();
    done = s.run("store a curve point");
  }
  return done;
}

Result<void> Store::forget_result(JobId job) {
  return db_.prepare("DELETE FROM result WHERE job = ?").bind(static_cast<std::uint64_t>(job)).run("forget a result");
}

}  // namespace regolab
