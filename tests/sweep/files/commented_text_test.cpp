// Files to begin with: every model and law gives one that reads back as it was and can be judged.
#include <catch2/catch.hpp>

#include "analysis/joint/keys.h"
#include "analysis/joint/parameters.h"
#include "analysis/stability/verdict.h"
#include "sweep/files/toml/commented_text.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/study/start/starting_joint.h"

#include <algorithm>

using namespace stickslip;

TEST_CASE("new: a commented joint of every model, law and motion reads back and has a verdict")
{
    for (const auto& motion : motions)
        for (const auto& model : models)
            for (const auto& law : laws()) {
                CAPTURE(motion.name, model.name, law.name);
                const Joint joint = starting_joint(model.value, std::string(law.name), motion.value);
                CHECK(check(joint).empty());
                const std::string text = commented_joint(joint);
                const Joint read = read_joint_text(text, "new");
                CHECK(canonical_text(read) == canonical_text(joint));
                CHECK(linear_verdict(read).steady.reason == Reason::none);
            }
}

TEST_CASE("new: every line that is commented out can be put in at its default")
{
    const Joint joint = starting_joint(Model::two_mass, "stribeck", Motion::revolute);
    std::string text = commented_joint(joint), open;
    for (std::size_t at = 0; at < text.size();) {
        const auto end = text.find('\n', at);
        const std::string line = text.substr(at, end - at);
        at = end + 1;
        const auto equals = line.find(" = ");
        const bool table = line.starts_with("# [") && line.ends_with("]");
        const bool key = line.starts_with("# ") && equals != std::string::npos && line.find(' ', 2) == equals;
        const auto value = key ? line.find_first_not_of(' ', equals + 2) : std::string::npos;
        const bool has_default = value != std::string::npos && line[value] != '#';
        open += (table || (key && has_default) ? line.substr(2) : line) + "\n";
    }
    CHECK(open.find("\n[sensor]\n") != std::string::npos);
    CHECK(canonical_text(read_joint_text(open, "opened")) == canonical_text(joint));
}

TEST_CASE("new: a commented spec is a sweep over both gains")
{
    for (const auto& model : models) {
        const Joint joint = starting_joint(model.value, "rate-and-state", Motion::prismatic);
        const Spec spec = read_spec_text(commented_spec(joint), "new");
        CHECK(spec.axes.size() == 2);
        CHECK(canonical_text(spec.joint) == canonical_text(joint));
    }
}

TEST_CASE("keys: numbers and words with their defaults, whatever stands in the joint")
{
    Joint joint = starting_joint(Model::single_mass, "rate-and-state", Motion::prismatic);
    joint.control.delay = 0.002;
    const auto all = keys(joint);
    const auto at = [&](const std::string& path) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const Key& k) { return k.path == path; });
        REQUIRE(found != all.end());
        return *found;
    };
    CHECK(at("control.delay").value == "0.002");
    CHECK(at("control.delay").standard == "0");
    CHECK(at("control.delay").in_force());
    CHECK(at("control.reference_velocity").standard == "true");
    CHECK_FALSE(at("control.reference_velocity").in_force());
    CHECK(at("joint.model").words.size() == 4);
    CHECK(at("friction.law").value == "rate-and-state");
    CHECK(at("control.effort_limit").standard == "inf");
    CHECK(choose(joint, "friction.law", "dahl"));
    CHECK(std::holds_alternative<Dahl>(joint.friction.law));
    CHECK_FALSE(choose(joint, "friction.law", "dhal"));
}
