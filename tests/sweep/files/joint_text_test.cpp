#include "analysis/joint/parameters.h"
#include "sweep/files/toml/joint_file.h"
#include "tests/sweep/files/messages.h"
#include "tests/temporary_directory.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

using namespace stickslip;

namespace {

/// Gives every leaf, choice and law of a joint a random value within its range.
struct Shuffler {
    std::mt19937_64& random;
    int size = 1;    // of every list in the struct at hand
    int tables = 0;  // files written for kernels

    bool coin() { return random() % 2 == 0; }
    double within(const Range& range)
    {
        const double magnitude = std::pow(10.0, std::uniform_real_distribution<>(-12, 18)(random));
        if (range.whole) return 1.0 + static_cast<double>(random() % 1000);
        if (std::isfinite(range.low) && std::isfinite(range.high)) {
            const double t = std::uniform_real_distribution<>(0.001, 0.999)(random);
            return range.low + t * (range.high - range.low);
        }
        if (std::isfinite(range.low)) return range.low + magnitude;
        return coin() ? magnitude : -magnitude;
    }
    void number(const Field& f, double& value)
    {
        if (f.need == Need::required || coin()) value = within(f.range);
    }
    void numbers(const Field& f, NumberList& list)
    {
        list = {};
        for (int i = 0; i < size; ++i) list.push_back(within(f.range));
    }
    void flag(std::string_view, std::string_view, bool& value) { value = coin(); }
    void text(std::string_view, std::string_view, std::string& value) { value = coin() ? "" : "a \"b\"\\\n\tµ.csv"; }
    void samples(std::string_view, std::string_view, std::string& name, KernelTablePtr& table)
    {
        if (coin()) return;
        name = (shared_directory() / ("\"g\" " + std::to_string(tables++) + ".csv")).string();
        const KernelTable samples{{0, 0.25, 1.5}, {3, -2, static_cast<double>(random())}};
        std::ofstream out(name);
        out << "time,g\n";
        out.precision(17);
        for (int i = 0; i < 3; ++i) out << samples.time[i] << ", " << samples.value[i] << "\n";
        table = std::make_shared<const KernelTable>(samples);
    }
    template <class Enum, std::size_t n>
    void choice(std::string_view, std::string_view, Enum& value, const Choice<Enum> (&choices)[n])
    {
        value = choices[random() % n].value;
    }
    template <class Struct>
    void table(std::string_view, std::string_view, Struct& s)
    {
        size = 1 + static_cast<int>(random() % 3);
        Struct::fields(s, *this);
    }
    template <class Struct, int capacity>
    void rows(std::string_view, std::string_view, ShortList<Struct, capacity>& list)
    {
        list = {};
        for (int i = 0; i < size; ++i) {
            list.push_back({});
            Struct::fields(list[i], *this);
        }
    }
    template <class... Laws>
    void law(std::variant<Laws...>& law)
    {
        const std::size_t wanted = random() % sizeof...(Laws);
        std::size_t i = 0;
        ((i++ == wanted ? void(law = Laws{}) : void()), ...);
        std::visit([this](auto& l) { std::decay_t<decltype(l)>::fields(l, *this); }, law);
    }
};

}  // namespace

TEST_CASE("a joint that is written reads back equal", "[slow]")
{
    const unsigned seed = 20240817;
    std::mt19937_64 random(seed);
    int valid = 0;
    for (int i = 0; i < 45000; ++i) {
        Joint joint;
        Shuffler shuffler{random};
        Joint::fields(joint, shuffler);
        if (!check(joint).empty()) continue;  // rules beyond ranges
        ++valid;
        const std::string text = joint_text(joint);
        INFO("seed " << seed << ", joint " << i << "\n" << text);
        Joint again;
        REQUIRE(messages_of([&] { again = read_joint_text(text, "written.toml"); }) == std::vector<std::string>{});
        REQUIRE(canonical_text(again) == canonical_text(joint));
        REQUIRE(joint_text(again) == text);
    }
    CHECK(valid > 500);
}

TEST_CASE("defaults are left out, units stand in comments")
{
    const Joint joint = read_joint_text(
        "joint = { motion = \"revolute\", inertia = 2 }\ncontrol.k_p = 12345678901234567000.0\n"
        "friction = { law = \"coulomb-viscous\", coulomb = 1, viscous = 0 }\n",
        "joint.toml");
    CHECK(joint_text(joint) == R"([joint]
motion = "revolute"
model = "single-mass"
inertia = 2   # kg·m²

[control]
kind = "position"
feedback = "motor"
structure = "pid"
anti_windup = "none"
k_p = 12345678901234567168.0   # N·m/rad

[friction]
law = "coulomb-viscous"
coulomb = 1   # N·m
viscous = 0   # N·m·s/rad
)");
}
