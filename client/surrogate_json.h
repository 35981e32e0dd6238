/// Surrogates as JSON; see json_view.h.
#pragma once
#include "client/json_view.h"

namespace regolab::client {

Json json_of(const pb::ModelSummary& model);
Json json_of(const pb::Estimate& estimate);
void add_predictions(const pb::PredictReply& reply, Json& document);
void add_inversion(const pb::InvertReply& reply, Json& document);

}  // namespace regolab::client
