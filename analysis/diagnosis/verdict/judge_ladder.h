// From a ladder to a name: against what is explainable at all, not against the encoder's noise.
#pragma once
#include "analysis/diagnosis/ladder/flexible.h"
#include "analysis/diagnosis/ladder/ladder.h"
#include "analysis/diagnosis/search/free_force.h"
#include "analysis/results/diagnosis.h"

#include <optional>

namespace stickslip::gap {

/// Squares beyond the noise on held-out rows: how far each step comes.
struct Shares {
    double documented = 0;  ///< as the document describes the joint: the whole gap
    double corrected = 0;   ///< with the corrections of the last rung
    double base = 0;        ///< with corrections refitted without any cause: what rungs are judged against
    std::vector<double> rungs;
    double explainable_to = 0;  ///< what a flexible force leaves
};

/// Parts of the whole gap, with a bootstrap over windows.
struct SharesWithInterval {
    double share = 0;
    double low = 0, high = 0;
};

struct JudgedLadder {
    Ladder ladder;
    Shares shares;
    Flexible of_corrected, of_last;
    Attribution winner;           ///< the last rung, or the corrections alone, at all levels; corrections come first
    std::size_t corrections = 0;  ///< effects at the head of the winner that are corrections
    bool noise_left = false;      ///< all that the winner leaves is noise
    bool noise_below = false;     ///< or was, with rungs below the last that were taken away
    double with_small_terms = infinity;  ///< mean log misfit with small terms of machines that were taken away
    /// Small terms of machines that were taken away from between its rungs. They are small beside any cause, so none of
    /// them speaks against one.
    std::vector<const Effect*> dropped;
    bool usual = false;             ///< the last cause is a small term that every machine has
    bool named = false;             ///< causes are named
    bool only_corrections = false;  ///< only documented parameters are wrong, by no more than such errors
    std::optional<Note> why_not;    ///< where nothing is named
    std::vector<double> chances;    ///< of every rung
    /// Numbers of the document that are causes beside the rungs, and what they take. In the winner they stand behind
    /// the causes, no longer among the corrections. Where there are no rungs: those of the corrections that take most.
    std::vector<std::pair<const Effect*, SharesWithInterval>> numbers;

    /// A set of causes with those numbers.
    std::vector<std::string> with_numbers(std::vector<std::string> causes) const;

    bool answers() const { return named || only_corrections; }
};

/// Judges what was climbed.
void judge(JudgedLadder& judged, const HeldOutData& data, const Fit& fit);

/// Odds of every rival of a rung against it, in the order of the ladder's; 0 of one that does not speak against it.
std::vector<double> odds_of_rivals(const JudgedLadder& judged, std::size_t rung);

/// How sure every rung is: against its rivals, and against what is left of the explainable.
std::vector<double> chances_of(const JudgedLadder& judged);

/// Whether corrections of the document alone take most of the gap, and of what is explainable of it.
bool corrections_take_most(const Shares& shares);

/// Whether the corrections take so much more of the gap than the last rung that it is not what the gap comes from.
bool small_against_corrections(const JudgedLadder& judged);

/// Takes the answer back where a force without a name explains the records clearly better. Beside corrections alone it
/// has to take as much as a cause would, since small things that every machine has are no answer either.
void hold_against(JudgedLadder& judged, const FreeFit& force);

/// Makes causes of those numbers of the document that are far off and take as much as the causes beside them do; where
/// there are none, and the corrections are the answer, finds those that take as much of what all corrections take.
void count_far_numbers(JudgedLadder& judged, const std::vector<FarNumber>& far);

/// A fitted set at all levels.
Attribution at_all_levels(const Fit& fit, const FittedSet& set);

/// Whether all that a fitted set leaves is noise.
bool leaves_noise(const Fit& fit, const FittedSet& set);

/// The signal that a force of this effect is a function of, in the words of Flexible.
std::string_view signal_of(const Effect& effect);

SharesWithInterval share_between(const std::vector<Window>& documented, const std::vector<Window>& above,
                                 const std::vector<Window>& below);

}  // namespace stickslip::gap
