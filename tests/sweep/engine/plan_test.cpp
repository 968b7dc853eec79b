// A plan has one meaning: its points are numbered, its id changes with whatever changes a number, and it survives the
// disk.
#include <bit>
#include <catch2/catch.hpp>
#include <functional>
#include <random>
#include <set>

#include "analysis/joint/parameters.h"
#include "sample_sweep.h"
#include "sweep/engine/plan_file.h"

using namespace sample;

TEST_CASE("points are numbered row-major, the first axis slowest")
{
    const auto swept = axes({3, 4, 5});
    PointCursor walking(joint(), swept), jumping(joint(), swept);
    std::uint64_t number = 0;
    for (const double k_p : swept[0].values)
        for (const double k_v : swept[1].values)
            for (const double V0 : swept[2].values) {
                jumping.seek(number);
                for (const PointCursor* cursor : {&walking, &jumping}) {
                    REQUIRE(cursor->joint().control.k_p == k_p);
                    REQUIRE(cursor->joint().control.k_v == k_v);
                    REQUIRE(cursor->joint().control.V0 == V0);
                }
                ++number;
                walking.advance();
            }
    CHECK(walking.joint().control.k_p == swept[0].values[0]);  // round to the first point
    CHECK(canonical_text(PointCursor(joint(), {}).joint()) == canonical_text(joint()));
}

TEST_CASE("a cursor equals a joint that was edited by name")
{
    const auto swept = axes({2, 3, 2, 3, 2});
    PointCursor cursor(joint(), swept);
    std::mt19937 random(20261121);
    for (int i = 0; i < 50; ++i) {
        const std::uint64_t number = random() % 72;
        cursor.seek(number);
        Joint edited = joint();
        std::uint64_t rest = number;
        for (std::size_t a = swept.size(); a-- > 0; rest /= swept[a].values.size())
            number_at(edited, swept[a].path) = swept[a].values[rest % swept[a].values.size()];
        CHECK(canonical_text(cursor.joint()) == canonical_text(edited));
    }
}

TEST_CASE("every chunk has its size, the last one the rest")
{
    Plan p = plan({10, 10}, 16);
    REQUIRE(p.chunks() == 7);
    std::uint64_t next = 0;
    for (std::uint64_t c = 0; c < p.chunks(); ++c) {
        CHECK(p.range(c).first == next);
        next += p.range(c).count;
    }
    CHECK(next == 100);
    CHECK(p.range(6).count == 4);
}

TEST_CASE("the id changes with everything that changes a result, down to one bit, and with nothing else")
{
    const Plan p = plan({4, 5}, 16, "o");
    std::set<std::string> ids{to_text(p.id)};
    const std::vector<std::function<void(Plan&)>> edits{
        [](Plan& q) { q.axes[0].values[2] = std::nextafter(q.axes[0].values[2], 0); },
        [](Plan& q) { std::swap(q.axes[0], q.axes[1]); },
        [](Plan& q) { q.joint += "x"; },
        [](Plan& q) { q.options = "another tolerance"; },
        [](Plan& q) { q.joint += "o", q.options = ""; },  // the same bytes in a row, cut elsewhere
        [](Plan& q) { q.nonlinear = true; },
        [](Plan& q) { q.units = Units(Motion::revolute); },
        [](Plan& q) { q.units.command = Command::duty; },
        [](Plan& q) { q.build += "x"; },
        [](Plan& q) { q.chunk_size = 32; },
        [](Plan& q) { q.axes[0].symbol = "another symbol"; },
        [](Plan& q) { q.axes[0].log = true; },
    };
    for (std::size_t i = 0; i < edits.size(); ++i) {
        Plan q = p;
        edits[i](q);
        CAPTURE(i);
        CHECK(ids.insert(to_text(id_of(q))).second);
    }
    Plan q = p;
    q.title = "another", q.spec = "another", q.command = "another", q.version = "another";
    CHECK(id_of(q) == p.id);
    CHECK(make_plan(joint(), axes({4, 5}), {.evaluation = "o"}).id ==
          make_plan(joint(), axes({4, 5}), {.evaluation = "o"}).id);
}

TEST_CASE("axes that cannot be swept are refused by name")
{
    const auto message = [](std::vector<Axis> swept) {
        try {
            make_plan(joint(), std::move(swept), {});
        } catch (const std::invalid_argument& e) {
            return std::string(e.what());
        }
        return std::string("accepted");
    };
    using Catch::Contains;
    CHECK_THAT(message({axis("control.kp", 3, 1, 2)}), Contains("\"control.kp\""));
    CHECK_THAT(message({axis("control.k_p", 3, 1, 2), axis("control.k_p", 3, 1, 2)}), Contains("twice"));
    CHECK_THAT(message({axis("friction.L", 3, 1, 2), axis("friction.L.0", 3, 1, 2)}), Contains("twice"));
    CHECK_THAT(message({axis("control.k_p", 0, 1, 2)}), Contains("no values"));
    CHECK_THAT(message({axis("friction.L", 3, -1, 1)}), Contains("\"friction.L\" holds -1") && Contains("> 0"));
    CHECK_THAT(message({axis("control.k_p", 1, std::nan(""), 1)}), Contains("nan"));
    CHECK_THAT(message({axis("control.k_p", 100000, 1, 2), axis("control.k_v", 100000, 1, 2),
                        axis("control.V0", 100000, 1, 2)}),
               Contains("1e+15 points") && Contains("36 PB of results") && Contains("12.7 years of one core"));
}

TEST_CASE("a chunk is worth journalling, small sweeps are shared out and huge ones keep a small index")
{
    for (const double cost : {1e-9, linear_point_cost, 1e-5, nonlinear_point_cost, 1.0})
        for (std::uint64_t points = 1; points <= max_points; points *= 7) {
            const std::uint64_t size = chunk_size_for(points, cost);
            CAPTURE(points, cost, size);
            CHECK(std::has_single_bit(size));
            CHECK((points + size - 1) / size <= (1u << 22));
        }
    CHECK(chunk_size_for(100'000'000, linear_point_cost) == 8192);
    CHECK(chunk_size_for(10'000, linear_point_cost) == 256);
    CHECK(chunk_size_for(1'000'000, 1e-3) == 64);
}

TEST_CASE("a plan comes back from JSON with every bit, and an edited one is found out")
{
    Plan p = plan({7, 3}, 16, "tolerance = 1e-9");
    for (double& value : p.axes[0].values) value /= 3;  // values that decimal digits cannot hold exactly
    p.axes[1].log = true;
    p.spec = "# “quoted” \"text\"\n\tκ = 1\n";
    p.id = id_of(p);
    const std::string text = to_json(p);
    const Plan back = plan_from_json(text);
    CHECK(back.id == p.id);
    CHECK(back.axes[0].values == p.axes[0].values);
    CHECK(back.axes[0].quantity == Quantity::stiffness);
    CHECK(back.spec == p.spec);
    CHECK(to_json(back) == text);

    std::string edited = text;
    edited.replace(edited.find("1e-9"), 4, "1e-8");
    CHECK_THROWS_WITH(plan_from_json(edited), Catch::Contains("does not agree with its id"));
    CHECK_THROWS_AS(plan_from_json(text.substr(0, text.size() / 2)), std::runtime_error);
    CHECK_THROWS_AS(plan_from_json("[]"), std::runtime_error);
    CHECK_THROWS_AS(plan_from_json(""), std::runtime_error);
}

TEST_CASE("every unit leads back to a quantity with that unit")
{
    for (const Units units : {Units(), Units(Motion::revolute), Units(Motion::prismatic, Command::voltage),
                              Units(Motion::revolute, Command::voltage), Units(Motion::revolute, Command::duty)})
        for (int i = 0; i <= static_cast<int>(Quantity::cubic_stiffness); ++i) {
            const auto unit = unit_of(static_cast<Quantity>(i), units);
            CHECK(unit_of(quantity_in(unit, units), units) == unit);
        }
    CHECK_THROWS_AS(quantity_in("furlong", {}), std::runtime_error);
}
