// What the findings of a diagnosis say in its answer: the named cause, rivals, what is unexplained. Internal to
// analysis/diagnosis.
#pragma once
#include "analysis/diagnosis/diagnose.h"
#include "analysis/diagnosis/search/attribute.h"
#include "analysis/diagnosis/verdict/find_causes.h"
#include "analysis/diagnosis/verdict/long_records.h"

#include <exception>
#include <string>
#include <vector>

namespace stickslip::gap {

/// The ladder's answer, the drive force that it leaves included.
void report_named(const Prepared& p, const ParallelFor& parallel, const Findings& f, Diagnosis& d);

void report_unexplained(const Findings& f, Diagnosis& d);

/// Where a velocity filter is named that is the documented one, discretised otherwise than the joint file means.
void report_filter(const Prepared& p, Diagnosis& d);

/// What it could be confused with, and the experiment that would tell.
void report_rivals(const Prepared& p, const ParallelFor& parallel, const Findings& f, const std::vector<Ranked>& ranked,
                   const Attribution& winner, Diagnosis& d);

/// The causes beside the ladder's, which names none: everything that was fitted, by probability.
void list_effects(const Prepared& p, const std::vector<Ranked>& ranked, Diagnosis& d);

/// Whether what is named has its numbers in the ladder: one that was accepted without corrections, too, where its
/// ladder is all it, as every document is a little off.
bool in_the_ladder(const Findings& f);

/// What a cause that was accepted without corrections gains on unseen data, and its numbers in the ladder where it has
/// one.
void report_first(const Prepared& p, const Findings& f, const HeldOut& held, Cause& cause);

}  // namespace stickslip::gap
