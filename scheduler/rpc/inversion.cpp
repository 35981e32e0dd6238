#include "scheduler/rpc/analysis_convert.h"
#include "scheduler/rpc/grpc_status.h"
#include "scheduler/rpc/surrogate_convert.h"
#include "scheduler/rpc/surrogate_source.h"
#include "scheduler/rpc/surrogates.h"
#include "scheduler/surrogate/invert.h"
#include "scheduler/surrogate/material.h"
#include "vocab/units.h"

namespace regolab {
namespace {

constexpr std::uint32_t kMostCandidates = 64;

/// The heading of a column in a design's table: "K_N_N_per_m".
std::string heading_of(const surrogate::InputColumn& column) {
  std::string text = column.name;
  text += unit_suffix(surrogate::input_unit(column));
  return text;
}

v1::Candidate to_proto(const surrogate::Model& model, const surrogate::Candidate& candidate) {
  v1::Candidate out;
  std::string row;
  for (std::size_t c = 0; c < model.data.columns.size(); ++c) {
    const auto& column = model.data.columns[c];
    const std::string text = surrogate::input_text(column, candidate.x[c]);
    (*out.mutable_set())[column.name] = text;
    if (!surrogate::is_of_the_run(column.name)) row += (row.empty() ? "" : ",") + text.substr(0, text.find(' '));
  }
  out.set_design_row(row);
  for (const auto& estimate : candidate.estimates) *out.add_estimates() = regolab::to_proto(estimate);
  out.set_probability(candidate.probability);
  out.set_miss(candidate.miss);
  return out;
}

v1::Freedom freedom_of(const surrogate::InputColumn& column, const surrogate::Question::Span& span) {
  v1::Freedom out;
  out.set_input(column.name);
  out.set_unit(surrogate::input_unit(column));
  const double factor = surrogate::input_factor(column);
  out.set_low(span.low * factor), out.set_high(span.high * factor);
  out.set_box_low(column.low * factor), out.set_box_high(column.high * factor);
  for (const double choice : span.choices) out.add_labels(column.labels[static_cast<std::size_t>(choice)]);
  return out;
}

void put(const surrogate::Model& model, const surrogate::Question& question, const surrogate::Inversion& found, v1::InvertReply& reply) {
  for (const auto& target : question.targets) {
    const DoorUnit door = door_unit(target.unit);
    v1::TargetValue& out = *reply.add_targets();
    out.set_response(target.response);
    out.set_unit(std::string(door.name));
    out.set_value(target.value * door.factor);
    out.set_tolerance(target.tolerance * door.factor);
  }
  for (const auto& candidate : found.candidates) *reply.add_candidates() = to_proto(model, candidate);
  for (std::size_t c = 0; c < model.data.columns.size(); ++c) {
    if (surrogate::is_of_the_run(model.data.columns[c].name)) continue;
    *reply.add_freedom() = freedom_of(model.data.columns[c], found.freedom[c]);
    reply.add_columns(heading_of(model.data.columns[c]));
  }
  reply.set_fitting(static_cast<std::uint32_t>(found.fitting));
  reply.set_tried(static_cast<std::uint32_t>(found.tried));
  for (const std::string& note : found.notes) reply.add_notes(note);
}

}  // namespace

grpc::Status SurrogatesService::Invert(grpc::ServerContext*, const v1::InvertRequest* request, v1::InvertReply* reply) {
  const auto held = model(request->model());
  if (!held.ok()) return to_grpc(held.error());
  reply->set_model((*held)->id);
  reply->set_model_name((*held)->name);
  const auto question = surrogate::read_target(request->file_name(), request->target_yaml(), **held);
  for (const Diagnostic& diagnostic : question.diagnostics) *reply->add_diagnostics() = regolab::to_proto(diagnostic);
  if (!question.ok()) return grpc::Status::OK;
  std::vector<surrogate::Source> sources;
  if (request->experiments_size() > 0) {
    auto reader = Reader::open(database_);
    if (!reader.ok()) return to_grpc(reader.error());
    for (const std::string& label : request->experiments()) {
      auto source = surrogate_source(*reader, label);
      if (!source.ok()) return to_grpc(source.error());
      sources.push_back(std::move(*source));
    }
  }
  const auto taught = surrogate::with_rows(**held, sources);
  if (!taught.ok()) return to_grpc(taught.error());
  const std::uint32_t wanted = request->candidates() == 0 ? 6 : std::min(request->candidates(), kMostCandidates);
  put(*taught, *question.value, surrogate::invert(*taught, *question.value, wanted), *reply);
  return grpc::Status::OK;
}

}  // namespace regolab
