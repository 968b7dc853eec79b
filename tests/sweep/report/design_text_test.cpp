// A design in words: an optimum at the end of the search is said to be one.
#include "sweep/report/pages/design_report.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("the answer of a design says that its optimum sits on the limit of the search", "[report]")
{
    DesignAnswer answer;
    answer.joint.control.k_p = 1e4;
    answer.range = {{1e3, 2e5}, {0, 100}};
    auto& d = answer.design;
    d.decided = d.feasible = true;
    d.best.k_p = 2e5, d.best.k_v = 40;
    d.best.margin = 0.2;
    const auto on = design_text(answer);
    CHECK(on.find("On the search limit: The best k_{p} is the greatest") != std::string::npos);
    d.best.k_p = 1e5;
    CHECK(design_text(answer).find("search limit") == std::string::npos);
}
