#include "tests/blind/generate/match.h"

#include "tests/blind/generate/mujoco.h"
#include "tests/blind/generate/random.h"

#include <algorithm>
#include <cmath>

namespace blind {

std::vector<Match> match_mujoco(const std::filesystem::path& folder, std::uint64_t seed, int count)
{
    std::vector<Match> list;
    for (int i = 0; i < count; ++i) {
        Draw draw(seed_of(seed, i));
        const auto& families = joint_families();
        const auto& kinds = excitation_kinds();
        const Nominal nominal = draw_nominal(families[i % families.size()], draw);
        const Excitation e = draw_excitation(kinds[i % kinds.size()], nominal.travel, nominal.speed, draw);
        const auto& s = nominal.machine.sensors;
        const double reading_noise = std::sqrt(s.position_noise * s.position_noise + s.quantum * s.quantum / 12);
        Machine quiet = nominal.machine;
        quiet.sensors = {};
        const Record own = run_loop(quiet, e, 0), other = run_mujoco(folder, {quiet}, {e}, {0}, 1)[0];
        Match m{nominal.family, e.kind};
        for (std::size_t k = 0; k < own.size(); ++k) {
            const double difference = std::abs(own.position[k] - other.position[k]) / reading_noise;
            m.rms += difference * difference / own.size();
            m.largest = std::max(m.largest, difference);
        }
        m.rms = std::sqrt(m.rms);
        list.push_back(m);
    }
    return list;
}

}  // namespace blind
