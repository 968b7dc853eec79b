#include "sweep/report/pages/set_point_design_report.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

/// The cards of a joint whose best way is this one, meaning behind number.
std::string cards_of(const SetPointChoice& best)
{
    SetPointDesignAnswer answer;
    answer.joint.mechanism.motion = Motion::revolute;
    answer.joint.friction.law = CoulombViscous{};
    answer.design.choices = {best};
    answer.design.best = 0;
    std::string cards;
    for (const auto& card : set_point_design_report(answer, {}).headlines)
        cards += card.value + " " + card.meaning + "\n";
    return cards;
}

}  // namespace

TEST_CASE("the ends of a set point's window stand beside the number that they are the ends of", "[report]")
{
    SetPointChoice both{SetPointWay::push_and_dead_zone, true, 750, 5.16e-5, 2.83, 1e-3};
    both.low = 4.92e-5, both.rest_error = 5.16e-5;
    CHECK_THAT(cards_of(both), Contains("dead zone of the error; at least 4.92×10^{−5} rad\n") &&
                                   Contains("2.83 N·m push towards the set point\n"));
    SetPointChoice push{SetPointWay::push_without_integral, true, 0, 0, 2.83, 1e-3};
    push.low = 0, push.high = 2.97, push.rest_error = 1e-3;
    CHECK_THAT(cards_of(push),
               Contains("push towards the set point; may lie from 0 N·m to 2.97 N·m") && !Contains("dead zone"));
}
