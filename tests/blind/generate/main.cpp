// blind_generate: makes blind test cases and, outside their folder, the answers.
#include "tests/blind/generate/files.h"
#include "tests/blind/generate/match.h"
#include "tests/blind/generate/random.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>

namespace {

void print(const char* name, const blind::SealedCase& c)
{
    std::string what = c.outside.empty() ? "" : "outside:" + c.outside;
    for (const auto& e : c.effects) what += (what.empty() ? "" : " + ") + e;
    std::printf("%s %-5s %-7s %-40s %-11s %-7s %-13s gap %6.2f -> %5.2f floors\n", name,
                c.setting.dirt ? "dirty" : "clean", c.kind.c_str(), what.c_str(), c.setting.nominal.family.c_str(),
                c.strength.c_str(), c.setting.columns.name.c_str(), c.gap.before, c.gap.after);
    std::fflush(stdout);
}

int print_match(const std::string& script_folder, std::uint64_t seed, int count)
{
    double worst = 0;
    for (const auto& m : blind::match_mujoco(script_folder, seed, count)) {
        std::printf("%-11s %-11s position differs by %.3f (RMS), %.2f (largest) of the reading noise\n",
                    m.family.c_str(), m.excitation.c_str(), m.rms, m.largest);
        worst = std::max(worst, m.rms);
    }
    std::printf("worst %.3f; matched: %s\n", worst, worst < 1 ? "yes" : "NO");
    return worst < 1 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app{
        "Makes blind test cases for `stickslip blind`: DIR/case-NN/{joint.toml, record-N.csv.gz}, and the truth "
        "outside "
        "DIR."};
    blind::Wish wish;
    std::string folder, truth_file, engine = "own", script_folder = "tests/blind/mujoco";
    std::uint64_t seed = 0;
    int cases = 30, first = 0;
    bool match = false;
    app.add_option("DIR", folder, "folder for the cases; must not hold cases yet");
    app.add_option("--cases", cases, "how many cases")->check(CLI::Range(1, 100000));
    app.add_option("--first", first, "number of the first case; case n does not depend on how many are made")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--kind", wish.kind, "what the cases are")
        ->check(CLI::IsMember({"single", "pair", "none", "outside", "noisy", "few", "mixed"}));
    const auto* seeded =
        app.add_option("--seed", seed, "seed; the same seed gives the same bytes. Without it: a fresh one, printed");
    app.add_option("--truth", truth_file, "file of the answers, added to if it is there (default: DIR.truth.json)");
    app.add_option("--effect", wish.effect, "only this effect of the catalogue")
        ->check(CLI::IsMember(blind::effect_names()));
    app.add_option("--strength", wish.strength, "only this strength")
        ->check(CLI::IsMember({"weak", "medium", "strong"}));
    app.add_option("--joint", wish.family, "only this family of joints")->check(CLI::IsMember(blind::joint_families()));
    app.add_option("--columns", wish.columns, "only this set of columns")
        ->check(CLI::IsMember(
            {"full", "no-effort", "no-velocity", "no-reference", "no-command", "motion-only", "position-only"}));
    app.add_option("--controller", wish.controller, "structure of the law; pid and cascade integrate")
        ->check(CLI::IsMember({"pd", "pid", "cascade"}));
    std::string state = "both";
    app.add_option("--state", state, "joints that are their documents, joints that are not quite, or either in turn")
        ->check(CLI::IsMember({"clean", "dirty", "both"}));
    app.add_flag_callback(
        "--dirty", [&] { state = "dirty"; }, "the same as --state dirty");
    app.add_option("--engine", engine, "who simulates the records")->check(CLI::IsMember({"own", "mujoco"}));
    app.add_option("--mujoco", script_folder, "folder of simulate.mjs, with its package installed");
    app.add_flag("--match", match,
                 "make no cases: print how well both mechanisms agree on nominal joints without noise");
    CLI11_PARSE(app, argc, argv);
    if (engine == "mujoco") wish.mujoco = script_folder;
    if (seeded->count() == 0) seed = std::random_device{}();
    std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
    if (match) return print_match(script_folder, seed, cases);
    if (folder.empty()) {
        std::cerr << "blind_generate: DIR is missing\n";
        return 2;
    }
    while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
    if (truth_file.empty()) truth_file = folder + ".truth.json";
    std::map<std::string, blind::SealedCase> made;
    int failed = 0;
    for (int i = first; i < first + cases; ++i) {
        char name[20];
        std::snprintf(name, sizeof name, "case-%03d", i);
        try {
            if (std::filesystem::exists(std::filesystem::path(folder) / name))
                throw std::runtime_error(folder + "/" + name + " exists already");
            wish.dirty = state == "dirty" || (state == "both" && i % 2 == 1);
            auto c = blind::make_case(wish, seed, i);
            blind::write_case(c, std::filesystem::path(folder) / name);
            print(name, c);
            c.setting.ensemble.clear();
            for (auto& r : c.records) r = {};  // the truth needs only what the gap has already measured
            made.emplace(name, std::move(c));
        } catch (const std::exception& e) {
            std::cerr << "blind_generate: " << name << ": " << e.what() << '\n';
            ++failed;
        }
    }
    std::string earlier;
    if (std::ifstream in(truth_file); in) earlier.assign(std::istreambuf_iterator<char>(in), {});
    const std::string truth = blind::truth_json(made, engine, earlier);
    std::ofstream out(truth_file);
    out << truth;
    if (!out) std::cerr << "blind_generate: cannot write " << truth_file << '\n';
    return !out ? 2 : failed ? 1 : 0;
}
