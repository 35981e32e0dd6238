/// The record of a set: every case as a line, the figures as JSON and as text.
#pragma once
#include <string>
#include <vector>

#include "scheduler/gap/blind/score.h"

namespace regolab::gap {

std::string record_csv(const std::vector<Mark>& marks);
std::string score_json(const Score& score);
std::string score_text(const Score& score);

}  // namespace regolab::gap
