// What the linear theory says of the joints of files, for tests/reliability/loops.py to hold against its own: reads
// paths on standard input, writes one line of JSON a joint. A number that is missing is null.
#include "analysis/stability/real_loop.h"
#include "sweep/files/toml/joint_file.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

int main()
{
    using namespace stickslip;
    using nlohmann::json;
    const auto number = [](double v) { return std::isfinite(v) ? json(v) : json(nullptr); };
    const auto windows = [&](const std::vector<Interval>& set) {
        json all = json::array();
        for (const auto& w : set) all.push_back({w.low, w.high < infinity ? json(w.high) : json(nullptr)});
        return all;
    };
    for (std::string path; std::getline(std::cin, path);) {
        json line = {{"file", path}};
        try {
            const Joint joint = read_joint(path);
            const auto verdict = linear_verdict(joint);
            const auto& memory = verdict.state_variable;
            line["reason"] = static_cast<int>(verdict.steady.reason);
            line["kind"] = static_cast<int>(verdict.loop.kind);
            line["stable"] = memory.stable;
            line["growth"] = number(memory.spectral_abscissa);
            line["point_growth"] = number(linear_point(joint).spectral_abscissa);
            line["velocity_only_growth"] = number(velocity_only_growth_rate(joint));
            line["windows"] = windows(memory.stable_intervals);
            line["searched_to"] = number(memory.searched_to);
            line["doubtful"] = memory.doubtful.size();
            line["k_v_windows"] = windows(verdict.velocity_only.stable_k_v);
            line["gain_margin_db"] = number(memory.gain_margin_db);
            line["phase_margin_deg"] = number(memory.phase_margin_deg);
        } catch (const std::exception& e) {
            line["error"] = e.what();
        }
        std::printf("%s\n", line.dump().c_str());
    }
}
