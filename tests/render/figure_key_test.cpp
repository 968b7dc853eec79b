#include "render/members.h"
#include "render/render.h"

#include <catch2/catch.hpp>

#include <functional>
#include <set>

using namespace stickslip;

namespace {

StabilityMap map()
{
    StabilityMap map;
    map.title = "ab";
    map.fixed = "c";
    map.x.values = {1, 2};
    map.abscissa = {1, 2, 3, 4};
    map.region = std::vector<Region>(4, Region::stable);
    map.curves.resize(1);
    return map;
}

std::string key_of(const Picture& picture)
{
    return figure_key({"id", picture, "caption", "finding"});
}

}  // namespace

TEST_CASE("the key of a figure follows every part of what is drawn", "[figure_key]")
{
    const std::vector<std::function<void(StabilityMap&)>> changes{
        [](auto&) {},
        [](auto& m) { m.title = "a", m.fixed = "bc"; },
        [](auto& m) { m.units = Units(Motion::revolute); },
        [](auto& m) { m.x.log = true; },
        [](auto& m) { m.y.log = true; },
        [](auto& m) { m.x.values = {1}, m.y.values = {2}; },
        [](auto& m) { m.abscissa[3] = 5; },
        [](auto& m) { m.region[2] = Region::bistable; },
        [](auto& m) { m.curves[0].precision = 1e-9; },
        [](auto& m) { m.curves[0].kind = Curve::Kind::fold; },
        [](auto& m) { m.curves[0].x = {1}; },
        [](auto& m) { m.design.inside = false; },
        [](auto& m) { m.has_design = true; },
        [](auto& m) { m.disagreement = 0.1; },
        [](auto& m) { m.undecided = 0.1; },
        [](auto& m) { m.readings.resize(1); },
        [](auto& m) { m.depth.name = "d"; },
        [](auto& m) { m.depth_value = 1; },
        [](auto& m) { m.layers.resize(1); },
        [](auto& m) { m.motions.resize(1); },
        [](auto& m) { m.command = "run"; },
    };
    std::set<std::string> keys;
    for (const auto& change : changes) {
        auto changed = map();
        change(changed);
        keys.insert(key_of(changed));
    }
    CHECK(keys.size() == changes.size());
    CHECK(key_of(map()) == key_of(map()));
    CHECK(key_of(LineChart{}) != key_of(DetailedChart{}));
    CHECK(figure_key({"id", map(), "caption", "finding"}) != figure_key({"id", map(), "caption", "other words"}));
    // the page writes these beside the picture
    CHECK(figure_key({"id", map(), "caption", "finding"}) == figure_key({"another", map(), "words", "finding"}));
}

TEST_CASE("no member of a struct is passed over", "[figure_key]")
{
    struct Three {
        std::string text;
        std::vector<double> list;
        bool flag = false;
    };
    CHECK(drawing::member_count<Three>() == 3);
    const Three three{"text", {1, 2}, true};
    CHECK(drawing::members(three) == std::tuple<std::string, std::vector<double>, bool>("text", {1, 2}, true));
    CHECK(drawing::member_count<DesignPoint>() == 5);
    CHECK(drawing::member_count<StabilityMap>() == 18);
}
