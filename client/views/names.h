/// Names of responses and columns as people and files see them.
#pragma once
#include <string>
#include <string_view>

#include "client/wire.h"

namespace regolab::client {

/// The article's own responses: contacts, density, void ratio, repose, sigma1, the force on plates.
bool is_primary(std::string_view response);

/// For table headers: "contacts", "density", "sigma1@2.5kPa"; secondary responses keep their id.
std::string short_name(std::string_view response);

/// Column names end in their door unit: "bulk_density_g_per_cm3", "K_N_N_per_m".
std::string column_of(const pb::ResponseColumn& response);
std::string column_of(const pb::FactorColumn& factor);

/// "g/cm3"; empty for plain numbers.
std::string shown_unit(std::string_view unit);

/// "theta_F (deg)".
std::string with_unit(std::string_view name, std::string_view unit);

/// The factor's label of a row; empty when the row does not say.
std::string label_of(const pb::ResultsReply& results, const pb::ResultRow& row, int factor);

}  // namespace regolab::client
