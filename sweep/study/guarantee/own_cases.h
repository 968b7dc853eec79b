// Blind cases on a user's own joint: the joint, not quite as documented and with a cause drawn from the catalogue,
// along the user's own references, with the noise of the user's own records.
#pragma once
#include "analysis/diagnosis/fit/effect.h"
#include "analysis/diagnosis/records/record.h"
#include "analysis/joint/joint.h"
#include "sweep/study/score.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace stickslip::guarantee {

struct OwnCase {
    blind::Truth truth;
    std::vector<Record> records;
};

/// Names of the effects that this joint could have.
std::vector<std::string> possible_causes(const Joint& joint);

/// Throws std::invalid_argument for joints and records that give no cases: no reference, no period of the loop, a joint
/// that cannot be simulated along a reference.
class OwnCases {
  public:
    OwnCases(const Joint& joint, const std::vector<Record>& records);

    /// Case n of this seed, whatever else is drawn: a joint whose inertia, Coulomb level, viscous slope and gravity are
    /// each 2 to 10 % off the document, with one cause (or, in one of as many cases as there are causes and one, none)
    /// that makes 1.5 to 4 times the gap of the rest, which counts as two noise floors at least. Nothing where the
    /// cause does not show so in this motion, or cannot be simulated.
    std::optional<OwnCase> make(std::uint64_t seed, std::uint64_t n) const;

    /// Causes that case numbers walk through, one after the other in an order drawn for each round; empty: none.
    const std::vector<std::string>& causes() const { return causes_; }
    /// Rows of all records: what a diagnosis takes is about proportional to them.
    double rows() const;

  private:
    Joint joint_;  ///< with the noise of the records where the document states none
    std::vector<Record> records_;
    std::vector<std::string> causes_;
    gap::Scales scales_;
};

}  // namespace stickslip::guarantee
