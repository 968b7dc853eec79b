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

struct Options {
    blind::Wish wish;
    std::string folder, truth_file, engine = "own", script_folder = "tests/blind/mujoco", state = "both";
    std::uint64_t seed = 0;
    int cases = 30, first = 0;
    bool match = false;
};

/// Declares the options of the program; gives that of the seed.
const CLI::Option* add_options(CLI::App& app, Options& o)
{
    app.add_option("DIR", o.folder, "folder for the cases; must not hold cases yet");
    app.add_option("--cases", o.cases, "how many cases")->check(CLI::Range(1, 100000));
    app.add_option("--first", o.first, "number of the first case; case n does not depend on how many are made")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--kind", o.wish.kind, "what the cases are")
        ->check(CLI::IsMember({"single", "pair", "none", "outside", "noisy", "few", "mixed"}));
    const auto* seeded =
        app.add_option("--seed", o.seed, "seed; the same seed gives the same bytes. Without it: a fresh one, printed");
    app.add_option("--truth", o.truth_file, "file of the answers, added to if it is there (default: DIR.truth.json)");
    app.add_option("--effect", o.wish.effect, "only this effect of the catalogue")
        ->check(CLI::IsMember(blind::effect_names()));
    app.add_option("--strength", o.wish.strength, "only this strength")
        ->check(CLI::IsMember({"weak", "medium", "strong"}));
    app.add_option("--joint", o.wish.family, "only this family of joints")
        ->check(CLI::IsMember(blind::joint_families()));
    app.add_option("--columns", o.wish.columns, "only this set of columns")
        ->check(CLI::IsMember(
            {"full", "no-effort", "no-velocity", "no-reference", "no-command", "motion-only", "position-only"}));
    app.add_option("--controller", o.wish.controller, "structure of the law; pid and cascade integrate")
        ->check(CLI::IsMember({"pd", "pid", "cascade"}));
    app.add_option("--state", o.state, "joints that are their documents, joints that are not quite, or either in turn")
        ->check(CLI::IsMember({"clean", "dirty", "both"}));
    app.add_flag_callback(
        "--dirty", [&o] { o.state = "dirty"; }, "the same as --state dirty");
    app.add_option("--engine", o.engine, "who simulates the records")->check(CLI::IsMember({"own", "mujoco"}));
    app.add_option("--mujoco", o.script_folder, "folder of simulate.mjs, with its package installed");
    app.add_flag("--match", o.match,
                 "make no cases: print how well both mechanisms agree on nominal joints without noise");
    return seeded;
}

struct Made {
    std::map<std::string, blind::SealedCase> cases;
    int failed = 0;
};

Made make_cases(Options& o)
{
    Made made;
    for (int i = o.first; i < o.first + o.cases; ++i) {
        char name[20];
        std::snprintf(name, sizeof name, "case-%03d", i);
        try {
            if (std::filesystem::exists(std::filesystem::path(o.folder) / name))
                throw std::runtime_error(o.folder + "/" + name + " exists already");
            o.wish.dirty = o.state == "dirty" || (o.state == "both" && i % 2 == 1);
            auto c = blind::make_case(o.wish, o.seed, i);
            blind::write_case(c, std::filesystem::path(o.folder) / name);
            print(name, c);
            c.setting.ensemble.clear();
            for (auto& r : c.records) r = {};  // the truth needs only what the gap has already measured
            made.cases.emplace(name, std::move(c));
        } catch (const std::exception& e) {
            std::cerr << "blind_generate: " << name << ": " << e.what() << '\n';
            ++made.failed;
        }
    }
    return made;
}

/// False where the file cannot be written.
bool add_truth(const Options& o, const Made& made)
{
    std::string earlier;
    if (std::ifstream in(o.truth_file); in) earlier.assign(std::istreambuf_iterator<char>(in), {});
    const std::string truth = blind::truth_json(made.cases, o.engine, earlier);
    std::ofstream out(o.truth_file);
    out << truth;
    if (!out) std::cerr << "blind_generate: cannot write " << o.truth_file << '\n';
    return static_cast<bool>(out);
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app{
        "Makes blind test cases for `stickslip blind`: DIR/case-NN/{joint.toml, record-N.csv.gz}, and the truth "
        "outside "
        "DIR."};
    Options o;
    const auto* seeded = add_options(app, o);
    CLI11_PARSE(app, argc, argv);
    if (o.engine == "mujoco") o.wish.mujoco = o.script_folder;
    if (seeded->count() == 0) o.seed = std::random_device{}();
    std::printf("seed %llu\n", static_cast<unsigned long long>(o.seed));
    if (o.match) return print_match(o.script_folder, o.seed, o.cases);
    if (o.folder.empty()) {
        std::cerr << "blind_generate: DIR is missing\n";
        return 2;
    }
    while (o.folder.size() > 1 && o.folder.back() == '/') o.folder.pop_back();
    if (o.truth_file.empty()) o.truth_file = o.folder + ".truth.json";
    const Made made = make_cases(o);
    return !add_truth(o, made) ? 2 : made.failed ? 1 : 0;
}
