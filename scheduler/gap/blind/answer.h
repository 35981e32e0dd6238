/// One answer: what the diagnosis said of one case, beside what the baselines said. As JSON it is what an answer's commitment is over.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scheduler/gap/blind/baselines.h"
#include "scheduler/gap/diagnosis.h"

namespace regolab::gap {

/// What made it, so that anybody can make it again.
struct AnswerSource {
  std::string bank;          ///< SHA-256 of its text, 12 digits
  std::string measurements;  ///< SHA-256 of the observation file
  std::string program;       ///< version
  std::uint64_t seed = 1;
  std::string protection;  ///< what kept the solver from reading the truth
};

struct Answer {
  std::string case_name;
  std::string problem;  ///< not empty: the file could not be diagnosed, which is CANNOT TELL
  Diagnosis diagnosis;
  Baselines baselines;
  AnswerSource source;
  std::string where;  ///< group that is off most surely, of an answer read back
};

std::string answer_text(const Answer& answer);
/// kDataLoss: no such text. Isolability and warnings are not read back.
Result<Answer> answer_from(const std::string& text);

}  // namespace regolab::gap
