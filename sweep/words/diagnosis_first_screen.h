// The first screen of a diagnosis: the answer in one sentence, the heading, and a card each for what, where, how
// much, how sure and what remains.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/diagnosis.h"
#include "analysis/results/report.h"

#include <string>
#include <vector>

namespace stickslip {

/// What the joint has, for an engineer who will change it, as sure as the first cause is.
std::string heading_of(const Diagnosis& d, const Joint& before, const Joint& after);

Headline what_card(const Diagnosis& d);

Headline where_card(const Diagnosis& d);

Headline how_much_card(const Diagnosis& d);

Headline how_sure_card(const Diagnosis& d);

/// What the ladder leaves of the gap, where there is one.
std::vector<Headline> remains_card(const Diagnosis& d);

/// The answer in one sentence, as sure as its probability.
std::string diagnosis_sentence(const Diagnosis& d);

}  // namespace stickslip
