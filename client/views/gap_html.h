/// A diagnosis as one HTML file: readable without JavaScript, without a network, and on paper.
#pragma once
#include <string>

#include "client/wire.h"

namespace regolab::client {

std::string diagnosis_html(const pb::Diagnosis& diagnosis, const pb::ImportReply& measured);

}  // namespace regolab::client
