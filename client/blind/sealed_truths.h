/// Truths under seal: made once, opened one at a time, each checked against what was committed to.
#pragma once
#include <string>
#include <vector>

#include "client/blind/folder.h"
#include "client/wire.h"

namespace regolab::client {

/// Seals and commits to them, into a folder that holds no set yet.
Outcome seal_truths(const pb::BlindDrawReply& drawn, const std::string& key, const BlindSet& set, BlindFolder& folder);

/// kInvalidInput: another key, or the truth is not the one committed to.
Outcome open_truth(const BlindFolder& folder, const Digest& commitment, const std::string& key, std::string& text);

}  // namespace regolab::client
