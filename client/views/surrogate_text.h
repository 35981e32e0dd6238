/// Surrogates as text: models, predictions, inverse design.
#pragma once
#include <string>

#include "client/wire.h"

namespace regolab::client {

/// Inputs with their ranges, then how well each response is predicted at points left out.
std::string model_text(const pb::ModelSummary& model);

/// One material: value, 90 % band of a run, band of the mean.
std::string prediction_text(const pb::Prediction& prediction);
std::string curve_text(const pb::EstimatedCurve& curve);

/// Targets, candidates beside them, what the targets leave open.
std::string inversion_text(const pb::InvertReply& reply);

/// "theta_F 40 deg, N_E 2", in the model's order.
std::string material_text(const google::protobuf::Map<std::string, std::string>& set, const pb::InvertReply& reply);

}  // namespace regolab::client
