/// A diagnosis as one HTML file: no script, no network, light and dark, fit to be printed.
#pragma once
#include <string>
#include <string_view>

#include "client/wire.h"

namespace regolab::client {

struct GapReport {
  pb::StoredDiagnosis stored;  ///< with its diagnosis
  std::string blind_record;    ///< how the method did on data whose effect was withheld; empty: no card
};

/// The figures of the last blind set, as the program was built with them.
std::string_view blind_record();

std::string diagnosis_html(const GapReport& report);

/// Text for between tags and inside quoted attributes.
std::string html_escaped(std::string_view text);

/// Measured curves beside both models, as inline SVG: sigma1/sigma3 and contraction for each sigma3. Empty without stress tests.
std::string curves_html(const pb::StoredDiagnosis& stored);

}  // namespace regolab::client
