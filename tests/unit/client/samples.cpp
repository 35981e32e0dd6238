#include "tests/unit/client/samples.h"

#include <numbers>

namespace regolab::client {
namespace {

void add_factor(pb::ResultsReply& results, const char* name, const char* unit, const char* low, const char* high) {
  auto* factor = results.add_factors();
  factor->set_name(name);
  factor->set_unit(unit);
  factor->add_levels(low);
  factor->add_levels(high);
}

void add_response(pb::ResultsReply& results, const char* id, const char* unit) {
  auto* response = results.add_responses();
  response->set_id(id);
  response->set_unit_si(unit);
}

pb::FactorAnalysis factor(const char* name, const char* unit, int rank, double range, double p, bool fragile) {
  pb::FactorAnalysis out;
  out.set_name(name);
  out.set_unit(unit);
  out.set_rank(rank);
  out.set_range(range);
  out.set_range_standard_error(0.02);
  out.set_highest_level("0.1");
  out.set_lowest_level("40");
  out.set_degrees_of_freedom(1);
  out.set_f(12.5);
  out.set_p(p);
  out.set_leave_one_out_range_min(range / 2);
  out.set_leave_one_out_range_max(range * 1.1);
  out.set_leaning_on_point(3);
  out.set_fragile(fragile);
  if (fragile) out.set_fragile_why("without point 3 it is not significant");
  for (const char* label : {"0.1", "40"}) {
    auto* level = out.add_levels();
    level->set_label(label);
    level->set_runs(2);
    level->set_sum(3.5);
    level->set_mean(1.75);
    level->set_half_width_95(0.015);
  }
  return out;
}

}  // namespace

pb::ResultsReply sample_results() {
  pb::ResultsReply results;
  results.set_experiment("E1");
  results.set_name("sample");
  results.set_array("L4 (2^3)");
  add_factor(results, "theta_F", "deg", "0.1", "40");
  add_factor(results, "N_E", "1", "2", "mixture");
  add_response(results, "contacts_per_particle", "1");
  add_response(results, "bulk_density", "kg/m3");
  add_response(results, "repose_angle", "rad");
  for (int point = 1; point <= 4; ++point) {
    auto* row = results.add_rows();
    row->set_point(point);
    row->set_seed(1);
    row->add_level((point - 1) / 2);
    row->add_level((point - 1) % 2);
    (*row->mutable_value_si())["contacts_per_particle"] = 3.0 + 0.1 * point;
    (*row->mutable_value_si())["bulk_density"] = 1700.0 - 50 * point;
    if (point < 4)
      (*row->mutable_value_si())["repose_angle"] = point * std::numbers::pi / 18;
    else
      (*row->mutable_missing())["repose_angle"] = "not settled (40 s of 40 s), \"raise\" the limit";
  }
  return results;
}

pb::RangeReply sample_range() {
  pb::RangeReply range;
  range.set_experiment("E1");
  for (const char* id : {"contacts_per_particle", "bulk_density"}) {
    auto* response = range.add_responses();
    response->set_response(id);
    response->set_unit(std::string(id) == "bulk_density" ? "g/cm3" : "1");
    response->set_runs_used(4);
    response->set_mean(1.575);
    response->set_residual_standard_deviation(0.022);
    response->set_error_degrees_of_freedom(1);
    response->set_seed_standard_deviation(0.01);
    *response->add_factors() = factor("N_E", "1", 2, 0.08, 0.4, true);
    *response->add_factors() = factor("theta_F", "deg", 1, 0.25, 0.0004, false);
    response->add_missing("point 4 seed 1: not settled (40 s)");
  }
  return range;
}

pb::ExperimentStatus sample_status(const std::string& state) {
  pb::ExperimentStatus status;
  status.set_experiment("E1");
  status.set_name("sample");
  status.set_state(state);
  status.set_workers(2);
  status.set_elapsed_s(61);
  status.set_remaining_s(720);
  auto* jobs = status.mutable_jobs();
  jobs->set_succeeded(37);
  jobs->set_reused(5);
  if (state == "running") {
    jobs->set_running(2);
    jobs->set_ready(100);
    jobs->set_blocked(85);
    auto* running = status.add_running();
    running->set_point(3);
    running->set_seed(1);
    running->set_stage("settle");
    running->set_phase("sedimentation");
    running->set_fraction(0.43);
    running->set_sphere_steps_per_s(8.4e6);
    running->set_worker("w1");
  }
  return status;
}

pb::DesignSummary sample_summary() {
  pb::DesignSummary summary;
  summary.set_name("sample");
  summary.set_array("L4 (2^3)");
  summary.set_points(4);
  summary.set_seeds(1);
  summary.set_strength(2);
  summary.set_balanced(true);
  summary.set_error_degrees_of_freedom(1);
  summary.add_factor_columns("theta_F: 2 levels, column 1");
  summary.add_factor_columns("N_E: 2 levels, column 2");
  summary.set_profile("quick");
  summary.add_tests("settle");
  summary.add_tests("repose");
  summary.set_jobs(12);
  summary.set_jobs_stored(3);
  summary.set_dem_jobs(6);
  return summary;
}

pb::TrainFunctionsReply sample_functions() {
  pb::TrainFunctionsReply reply;
  reply.set_experiment("article");
  reply.set_seed(3);
  auto& function = *reply.add_functions();
  function.set_name("BP-ANN-1");
  function.add_inputs("theta_F");
  function.set_folds(4);
  auto& output = *function.add_outputs();
  output.set_response("bulk_density");
  output.set_unit("g/cm3");
  output.mutable_left_out()->set_rows(4);
  output.mutable_left_out()->set_r(0.97125);
  output.mutable_left_out()->set_rms(0.0281);
  int point = 1;
  for (const char* name : {"training", "validation", "test", "all"}) {
    auto& group = *function.add_groups();
    group.set_name(name);
    if (point < 4) group.add_points(point++);
    if (point > 2) group.set_r(0.98765);  // one point has no R
    group.set_article_r(0.937);
    output.add_groups()->set_rows(1);
  }
  reply.add_functions()->set_name("BP-ANN-2");
  reply.mutable_functions(1)->set_problem("experiment E1 does not vary K_N (why) remedy");
  reply.add_notes("a note");
  return reply;
}

}  // namespace regolab::client
