/// From evidence to an answer: prior probabilities, what counts as sure, and the six verdicts.
#pragma once
#include "scheduler/gap/diagnosis.h"

namespace regolab::gap {

/// Of a class before any data, where `singles` single effects take part.
double prior_of(const std::string& cause, double singles);

/// Posterior probabilities from log Z / temperature and the prior; sorts the models by them.
void weigh(std::vector<Weighed>& models, double temperature);

/// Where the best named model misfits (adequacy below 1/e), what the unknown gains: the most that such a p can speak for anything else, the
/// bound -e p ln p [Sellke, Bayarri and Berger 2001, doi 10.1198/000313001300339950]. The unknown's own evidence knows only shifts like the
/// library's. REQUIRES: one model of the cause "unknown", adequacy > 0.
void doubt(std::vector<Weighed>& models, double adequacy);

/// What fits mostly by the emulator's own error about its effects is nearly an unknown itself: that share of its probability goes there.
/// REQUIRES: as `doubt`.
void mistrust(std::vector<Weighed>& models);

/// Probability of each class, most probable first.
std::vector<std::pair<std::string, double>> by_class(const std::vector<Weighed>& models);

/// Verdict and classes, from models, isolability and adequacy. A pair is named only where this very code measured; else it is one of two.
void decide(Diagnosis& diagnosis);

}  // namespace regolab::gap
