// A joint and its record as files: from_files JOINT.toml RECORD.csv. Without arguments both are made here first.
#include <stickslip/diagnosis.h>
#include <stickslip/joint_file.h>
#include <stickslip/record_file.h>
#include <stickslip/reference_file.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "threads.h"

namespace {

void make(const std::filesystem::path& joint_file, const std::filesystem::path& folder)
{
    stickslip::Joint joint = stickslip::read_joint_text(R"(
        [joint]
        motion = "revolute"
        inertia = 0.05          # kg·m²
        [control]
        k_p = 20.0              # N·m/rad
        k_v = 0.5               # N·m·s/rad
        period = "1 ms"
        velocity_estimate = { form = "backward-difference" }
        [friction]
        law = "coulomb-viscous"
        coulomb = 0.3           # N·m
        viscous = 0.05          # N·m·s/rad
        [sensor]
        position_noise = 1e-6   # rad
    )",
                                                        "made here");
    std::ofstream(joint_file) << stickslip::joint_text(joint);

    stickslip::ReferenceMotion reference;
    for (int i = 0; i < 3000; ++i) {
        const double t = 1e-3 * i;
        reference.time.push_back(t);
        reference.position.push_back(t < 2 ? 0.5 * (1 - std::cos(2 * M_PI * t)) : 0);
    }
    stickslip::apply_setting(joint, "load.constant=0.2");  // N·m, which the file does not say
    stickslip::write_record(stickslip::record_along(joint, reference, 1), folder);
}

}  // namespace

int main(int count, char** arguments)
try {
    const std::filesystem::path joint_file = count > 2 ? arguments[1] : "joint.toml";
    const std::filesystem::path record_file = count > 2 ? arguments[2] : "record.csv";
    if (count <= 2) make(joint_file, ".");

    const auto joint = stickslip::read_joint(joint_file);
    const auto read = stickslip::read_record(record_file, joint);
    for (const auto& warning : read.sentences()) std::printf("%s: %s\n", record_file.c_str(), warning.c_str());
    const auto found = stickslip::gap::diagnose(joint, {read.record}, side_by_side).diagnosis;
    std::printf("%s\n", name_of(found.verdict).c_str());
    for (const auto& cause : found.effects) std::printf("%-20s %.3f\n", cause.names[0].c_str(), cause.probability);
} catch (const stickslip::BadInput& bad) {
    for (const auto& message : bad.messages()) std::fprintf(stderr, "%s\n", message.c_str());
    return 2;
}
