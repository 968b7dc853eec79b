// Rules by which a gap has become worse, on diagnoses written by hand; dates in names.
#include "sweep/study/check/gap_check.h"
#include "sweep/study/compare/timeline.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

DiagnosisFacts no_gap()
{
    DiagnosisFacts d;
    d.verdict = Verdict::no_gap;
    d.overall.before = d.overall.after = 0.97;
    return d;
}

DiagnosisFacts gap_of(const std::string& cause, double coulomb, double error, double floors)
{
    DiagnosisFacts d;
    d.verdict = Verdict::gap;
    d.causes = {cause};
    d.overall.before = floors, d.overall.after = 1;
    d.numbers = {{FoundNumber::Of::sheet, {"Coulomb level", coulomb, error, "N"}}};
    return d;
}

std::vector<GapRegression::Kind> kinds(const DiagnosisFacts& before, const DiagnosisFacts& after)
{
    std::vector<GapRegression::Kind> all;
    for (const auto& r : gap_regressions(compare_diagnoses(before, after), {})) all.push_back(r.kind);
    return all;
}

using Kind = GapRegression::Kind;
using Kinds = std::vector<Kind>;

}  // namespace

TEST_CASE("a gap that is new, grown, of another cause or another size is a regression, and one that shrinks is none",
          "[check]")
{
    const auto was = gap_of("coulomb-level", 1.2, 0.004, 4);
    CHECK(kinds(no_gap(), no_gap()).empty());
    CHECK(kinds(no_gap(), was) == Kinds{Kind::new_gap});
    CHECK(kinds(was, no_gap()).empty());
    CHECK(kinds(was, was).empty());
    CHECK(kinds(was, gap_of("coulomb-level", 1.2, 0.004, 4.3)).empty());
    CHECK(kinds(was, gap_of("coulomb-level", 1.2, 0.004, 4.5)) == Kinds{Kind::grown});
    CHECK(kinds(was, gap_of("coulomb-level", 1.32, 0.004, 4)) == Kinds{Kind::number_moved});
    CHECK(kinds(was, gap_of("coulomb-level", 1.32, 0.1, 4)).empty());    // not beyond its errors
    CHECK(kinds(was, gap_of("coulomb-level", 1.23, 0.001, 4)).empty());  // beyond them, but by 2.5 % alone
    CHECK(kinds(was, gap_of("backlash", 1.2, 0.004, 4)) == Kinds{Kind::new_cause});
    auto vague = gap_of("backlash", 1.2, 0.004, 4);
    vague.ambiguous_with = {{"coulomb-level"}};
    CHECK(kinds(was, vague).empty());
    auto rest = was;
    rest.overall.after = 1.2;
    CHECK(kinds(was, rest) == Kinds{Kind::remainder});
    DiagnosisFacts poor;
    CHECK(kinds(was, poor) == Kinds{Kind::no_answer});
    CHECK(kinds(poor, poor).empty());
}

TEST_CASE("a number's change is held against both standard errors", "[check]")
{
    const auto c = compare_diagnoses(gap_of("coulomb-level", 1.2, 0.03, 4), gap_of("coulomb-level", 1.3, 0.04, 4));
    REQUIRE(c.numbers.size() == 1);
    CHECK(c.numbers[0].standard_errors == Approx(0.1 / 0.05));
    CHECK_FALSE(c.numbers[0].moved(3));
    CHECK(c.numbers[0].moved(1.9));
    const auto alone = compare_diagnoses(no_gap(), gap_of("coulomb-level", 1.3, 0.04, 4));
    CHECK(std::isnan(alone.numbers.at(0).standard_errors));
    CHECK_FALSE(alone.numbers.at(0).moved(0));
    CHECK(alone.gap == GapChange::appeared);
}

TEST_CASE("dates are read from names as they are commonly written, and nothing else is taken for one", "[check]")
{
    const auto read = [](const char* name) {
        const auto date = date_in(name);
        return date ? date_text(*date) : "none";
    };
    CHECK(read("2026-03-01") == "2026-03-01");
    CHECK(read("elbow-2026-03-01T14-30") == "2026-03-01 14:30");
    CHECK(read("20260301_143000") == "2026-03-01 14:30");
    CHECK(read("run 2024-02-29") == "2024-02-29");
    CHECK(read("2023-02-29") == "none");
    CHECK(read("case-123456789") == "none");
    CHECK(read("arm-7") == "none");
    CHECK(days_between(*date_in("2026-02-28"), *date_in("2026-03-02T12:00")) == Approx(2.5));
}
