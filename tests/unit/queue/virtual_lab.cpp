#include "virtual_lab.h"

#include <gtest/gtest.h>

namespace regolab::test {
namespace {
constexpr Millis kRunTime = 120;  // of a stage
constexpr Millis kResend = 60;    // a worker repeats an unanswered report
constexpr Millis kDeadline = 30;  // a worker speaks at least this often
constexpr std::uint64_t kTickEvery = 10;
}  // namespace

VirtualLab::VirtualLab(std::uint64_t seed, int workers) : random_(seed), queue_(policy_, LeaseToken{0}) {
  machines_.resize(static_cast<std::size_t>(workers));
  for (Machine& m : machines_) replace(m);
}

StageResult VirtualLab::truth(const StageSpec& spec) {
  StageResult result;
  result.end = unphysical(spec) ? StageEnd::kNotSettled : StageEnd::kCompleted;
  result.measurements.push_back({"key", static_cast<double>(std::hash<std::string>{}(stage_key(spec))), "1", {}, ""});
  return result;
}

void VirtualLab::replace(Machine& machine) {
  machine = {};
  machine.name = "worker-" + std::to_string(++born_);
}

void VirtualLab::submit(const std::vector<Wish>& wishes) {
  Effects effects;
  queue_.submit(wishes, now, effects);
  tables.apply(effects);
  check();
}

void VirtualLab::cancel_last() {
  const ExperimentId id = tables.studies.rbegin()->first;
  Effects effects;
  queue_.cancel(id, now, effects);
  tables.apply(effects);
  for (const auto& [job, record] : tables.jobs) {
    if (record.status.state == JobState::kCancelled) dead_.insert(job);
  }
  for (const Effect& effect : effects) {
    if (const auto* revoked = std::get_if<LeaseRevoked>(&effect); revoked && held_.contains(revoked->worker)) {
      held_.erase(revoked->worker);
    }
  }
  check();
}

void VirtualLab::send(Message message, const Faults& f) {
  const int copies = chance(f.lose) ? 0 : chance(f.twice) ? 2 : 1;
  for (int i = 0; i < copies; ++i) {
    message.at = now + way(f);
    message.order = ++order_;
    network_.push(message);
  }
}

bool VirtualLab::commit(Effects& effects, const Faults& f) {
  if (chance(f.commit_fails)) {
    reload();
    return false;
  }
  tables.apply(effects);
  check();
  return true;
}

void VirtualLab::reload() {
  ++restarts;
  queue_ = tables.load(policy_, queue_.last_token(), now);
  held_.clear();
}

void VirtualLab::answer(const WorkerReport& report, const Order& order, const Faults& f) {
  send({0, 0, false, report, order}, f);
}

void VirtualLab::scheduler_hears(const Message& message, const Faults& f) {
  if (chance(f.scheduler_crash)) return reload();  // before the commit
  Effects effects;
  if (chance(f.bed_loss)) {
    for (const auto& [id, record] : tables.jobs) {
      if (!record.status.bed.empty() && chance(0.2)) queue_.bed_lost(record.status.bed, now, effects);
    }
  }
  const auto order = queue_.exchange(message.report, now, effects);
  if (!commit(effects, f)) return;
  if (chance(f.scheduler_crash)) return reload();  // after the commit, before the answer
  if (!order) {
    held_[message.report.worker] = message.report;
    return;
  }
  held_.erase(message.report.worker);
  if (std::holds_alternative<OrderDrop>(*order)) ++refused;
  answer(message.report, *order, f);
}

WorkerReport VirtualLab::say(Machine& m, decltype(WorkerReport::slot) slot) {
  m.report = {m.name, ++m.seq, false, std::move(slot)};
  m.waiting = true;
  m.spoke = now;
  return m.report;
}

void VirtualLab::worker_acts(Machine& m, const Faults& f) {
  if (now < m.paused_until) return;
  if (m.waiting && now - m.spoke < kResend) return;
  if (m.waiting && !(m.job && now - m.begun >= kRunTime && std::holds_alternative<WorkerRunning>(m.report.slot))) {
    m.spoke = now;
    return send({0, 0, true, m.report, {}}, f);  // the very same report again
  }
  if (!m.job) return send({0, 0, true, say(m, WorkerIdle{}), {}}, f);
  const StageSpec& spec = m.job->spec;
  const auto steps = static_cast<std::uint64_t>(now - m.begun);
  if (poison(spec) && now - m.begun > kRunTime / 2) {
    ++crashes;
    return replace(m);
  }
  if (now - m.begun < kRunTime) {
    if (now - m.spoke < kDeadline) return;
    return send({0, 0, true, say(m, WorkerRunning{m.job->job, m.job->token, {"run", 0.5, steps, 1}, ""}), {}}, f);
  }
  WorkerFinished done{m.job->job, m.job->token, std::make_shared<const StageResult>(truth(spec)), "", 0.1, steps};
  if (broken(spec))
    done.outcome = JobFailure{FailureClass::kPermanent, "broken"};
  else if (chance(f.transient))
    done.outcome = JobFailure{FailureClass::kTransient, "unlucky"};
  else if (!needs_bed(spec.kind) && !unphysical(spec))
    done.bed = "bed of " + stage_key(spec);
  send({0, 0, true, say(m, std::move(done)), {}}, f);
}

void VirtualLab::worker_hears(Machine& m, const Message& message, const Faults&) {
  if (!m.waiting || message.report.seq != m.seq) return;  // an answer to something older
  m.waiting = false;
  const bool finished = std::holds_alternative<WorkerFinished>(m.report.slot);
  if (const auto* start = std::get_if<OrderStart>(&message.answer)) {
    m.job = *start;
    m.begun = now;
    EXPECT_EQ(start->bed, needs_bed(start->spec.kind) ? "bed of " + stage_key(parent_of(start->spec)) : "");
  } else if (std::holds_alternative<OrderDrop>(message.answer) || finished) {
    m.job.reset();
  }
}

void VirtualLab::run(Millis until, const Faults& f) {
  for (; now < until; ++now) {
    while (!network_.empty() && network_.top().at <= now) {
      const Message message = network_.top();
      network_.pop();
      if (message.to_scheduler) {
        scheduler_hears(message, f);
        continue;
      }
      for (Machine& m : machines_) {
        if (m.name == message.report.worker && now >= m.paused_until) worker_hears(m, message, f);
      }
    }
    for (Machine& m : machines_) {
      if (chance(f.worker_crash)) {
        ++crashes;
        replace(m);
      }
      if (chance(f.worker_pause)) m.paused_until = now + 2 * policy_.lease_ttl;
      worker_acts(m, f);
    }
    if (static_cast<std::uint64_t>(now) % kTickEvery != 0) continue;
    Effects effects;
    queue_.tick(now, effects);
    std::vector<std::pair<WorkerReport, Order>> answers;
    for (const auto& [name, report] : held_) {
      if (!queue_.anything_ready() || !std::holds_alternative<WorkerIdle>(report.slot)) continue;
      if (auto order = queue_.poll(name, now, effects)) answers.emplace_back(report, *order);
    }
    if (!commit(effects, f)) continue;
    for (const auto& [report, order] : answers) {
      held_.erase(report.worker);
      answer(report, order, f);
    }
    for (auto held = held_.begin(); held != held_.end();) {  // the hold time of a running worker's call is short
      if (std::holds_alternative<WorkerRunning>(held->second.slot)) {
        answer(held->second, OrderKeep{}, f);
        held = held_.erase(held);
      } else {
        ++held;
      }
    }
  }
}

void VirtualLab::check() {
  ASSERT_TRUE(tables.breaches.empty()) << tables.breaches.front();
  for (const auto& [id, record] : tables.jobs) {
    const JobQueue::Job* job = queue_.find(id);
    ASSERT_TRUE(job && job->status == record.status) << "I8: tables and queue agree";
    ASSERT_LE(record.status.attempts, policy_.max_attempts) << "I5";
    ASSERT_TRUE(!dead_.contains(id) || !tables.results.contains(id)) << "I6: nothing commits after a cancel";
  }
}

bool VirtualLab::quiet() const {
  for (const auto& [id, study] : tables.studies) {
    if (study.state == ExperimentState::kRunning) return false;
  }
  return true;
}

void VirtualLab::check_end() {
  EXPECT_TRUE(quiet()) << "I11: every job ends once the faults have stopped";
  for (const auto& [id, record] : tables.jobs) {
    const StageSpec& spec = record.identity.spec;
    const JobState state = record.status.state;
    if (dead_.contains(id)) continue;
    const JobState due = needs_bed(spec.kind) && unphysical(parent_of(spec)) ? JobState::kSkipped
                         : poison(spec)                                      ? JobState::kQuarantined
                         : broken(spec)                                      ? JobState::kFailed
                                                                             : JobState::kSucceeded;
    EXPECT_EQ(name_of(state), name_of(due)) << "job " << static_cast<std::uint64_t>(id);
    ASSERT_EQ(tables.results.contains(id), state == JobState::kSucceeded) << "I2";
    EXPECT_TRUE(state != JobState::kSucceeded || tables.results.at(id) == truth(spec)) << "I10";
  }
}

}  // namespace regolab::test
