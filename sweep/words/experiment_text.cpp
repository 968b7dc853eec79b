#include "sweep/words/experiment_text.h"

#include "analysis/results/text.h"
#include "sweep/study/motion_reach.h"
#include "sweep/words/cause_text.h"
#include "sweep/words/diagnosis_tables.h"

#include <fmt/format.h>

namespace stickslip {
namespace {

constexpr double beyond_doubt = 100, seen = 1;  ///< noise standard deviations

std::string reach_text(const MotionReach& reach, Units units)
{
    return fmt::format(
        "It moves between {} and {}, with at most {} and {}, and takes {}. Before running it, check that the machine "
        "is free over that stroke and may move that fast; the program knows only the records.",
        with_unit(reach.low, Quantity::position, units), with_unit(reach.high, Quantity::position, units),
        with_unit(reach.fastest, Quantity::velocity, units),
        with_error(reach.hardest, 0, units.motion == Motion::revolute ? "rad/s²" : "m/s²"),
        with_unit(reach.duration, Quantity::time, units));
}

/// "gravity + inertia" in words.
std::string causes_text(std::string_view joined)
{
    constexpr std::string_view plus = " + ";
    std::vector<std::string> names;
    for (std::size_t at = 0; at != std::string_view::npos;) {
        const auto end = joined.find(plus, at);
        names.emplace_back(joined.substr(at, end - at));
        at = end == std::string_view::npos ? end : end + plus.size();
    }
    return together(names);
}

}  // namespace

std::string_view motion_text(TestMotion motion)
{
    switch (motion) {
        case TestMotion::none:
            break;
        case TestMotion::slow_stroke:
            return "to and fro over the stroke at a fiftieth of the largest speed";
        case TestMotion::small_sine:
            return "a sine of small amplitude with many reversals";
        case TestMotion::falling_sine:
            return "a sine from 0.2 to 5 Hz whose amplitude falls as its frequency rises";
        case TestMotion::steps_and_rests:
            return "steps over the whole stroke with standstills of one and a half seconds";
        case TestMotion::steps_of_speed:
            return "steps of speed: a tenth, a third and the whole of the largest speed";
        case TestMotion::rig_step_down:
            return "a step down to a tenth of the first speed and back";
        case TestMotion::rig_step_up:
            return "a step up to ten times the first speed and back";
        case TestMotion::rig_hold:
            return "a hold at rest between two slides at the first speed";
    }
    return "";
}

bool has_motion(const NextExperiment& e)
{
    return e.motion != TestMotion::none && !e.separates.empty() && !(e.distance < seen) && !e.reference.empty();
}

std::string next_experiment_text(const Diagnosis& d)
{
    const auto& e = d.next_experiment;
    if (e.motion == TestMotion::none || e.separates.empty())
        return d.verdict == Verdict::gap || d.verdict == Verdict::no_gap
                   ? "No causes remain to be distinguished."
                   : "No motion was found that would distinguish the named causes.";
    const std::string one = causes_text(e.separates[0].first), two = causes_text(e.separates[0].second);
    if (e.distance < seen)
        return fmt::format(
            "No motion that was tried would distinguish {} from {}: with the fitted parameters, even along {} they "
            "differ by only {:.1g} noise standard deviations. For a simulation either will do.",
            one, two, motion_text(e.motion), e.distance);
    auto text = fmt::format("Move along {}: there {} and {} differ by {}.", motion_text(e.motion), one, two,
                            e.distance > beyond_doubt ? std::string("more than a hundred noise standard deviations")
                                                      : fmt::format("{:.1f} noise standard deviations", e.distance));
    if (!e.reference.empty())
        text +=
            " The reference is next-experiment.csv beside this page: continuous, from rest to rest, within the "
            "stroke and the speed that the records show; its acceleration is given below. " +
            reach_text(reach_of(e.time, e.reference), Units(d.motion));
    return text;
}

}  // namespace stickslip
