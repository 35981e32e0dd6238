/// The DEM runs that confirm a diagnosis: draws of the re-calibrated base model and of the repaired one, as a study for the queue.
#pragma once
#include <set>
#include <string>

#include "regolab/v1/lab.pb.h"
#include "scheduler/gap/observation.h"
#include "vocab/result.h"

namespace regolab {

/// Where the seeds of a diagnosis' runs begin: from its id, so that no two share any, and away from those of the bank.
std::uint64_t first_seed_of(const std::string& id, const std::set<std::uint64_t>& bank_seeds);

/// Draws first to first + draws - 1 of the base model, then of the repaired one where there is any: one specimen each, with a seed of its
/// own, under the held-out stresses alone, with the bank's numerics and the specimen that was measured. kFailedPrecondition: nothing to confirm.
Result<v1::SubmitRequest> confirmation_design(const v1::Diagnosis& diagnosis, const gap::ObservationSet& set, int first, int draws);

/// Whether such a study runs specimens of the size that was measured; else of the bank's.
bool runs_measured_size(const gap::ObservationSet& set);

/// The model that such a study runs beside "none"; null when it runs none.
const v1::WeighedModel* repaired_model(const v1::Diagnosis& diagnosis);

}  // namespace regolab
