// stickslip calibrate: blind cases on a user's own joint, answered, for `diagnose --guarantee`.
#include "analysis/diagnosis/diagnose.h"
#include "sweep/engine/build.h"
#include "sweep/files/json/calibration_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/diagnosis_verbs.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/gather_records.h"
#include "sweep/program/verbs/guarantee_option.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/stoppable.h"
#include "sweep/study/diagnose.h"
#include "sweep/study/guarantee/order_statistic.h"
#include "sweep/study/guarantee/own_cases.h"
#include "sweep/words/guarantee_text.h"
#include "sweep/words/refusal_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::string joint, output = "calibration.json", shard = "1/1";
    std::vector<std::string> records;
    std::uint64_t seed = 1;
    int cases = 59, threads = 0;
};

struct Shard {
    int number = 1, of = 1;
};

Shard shard_of(const std::string& text)
{
    Shard s;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%d/%d%c", &s.number, &s.of, &rest) != 2 || s.of < 1 || s.number < 1 ||
        s.number > s.of)
        throw BadInput("--shard: got \"" + text + "\", expected K/M with 1 ≤ K ≤ M");
    return s;
}

std::string name_of_case(std::uint64_t seed, int n, const std::string& joint)
{
    return fmt::format("{}-{}-{}", joint, seed, n);
}

/// What an earlier run wrote, if it is of this joint and answered by this program; else nothing.
guarantee::Calibration begun(const Options& options, guarantee::Calibration empty)
{
    if (!std::filesystem::exists(options.output)) return empty;
    auto earlier = read_calibrations({options.output});
    if (earlier.method != empty.method)
        throw BadInput(options.output +
                       ": was answered by other sources of the diagnosis; choose another file with -o");
    if (earlier.joint != empty.joint)
        throw BadInput(options.output + ": is of another joint; choose another file with -o");
    return earlier;
}

/// Seconds of computing that a diagnosis takes for each row. Reason: an estimate before anything was timed. Evidence:
/// dirty blind cases of about 60 000 rows took 30 to 47 s (docs/validation.md).
constexpr double seconds_per_row = 6e-4;

void tell_plan(const guarantee::OwnCases& cases, const std::vector<int>& left)
{
    const int needed = guarantee::fewest_that_cover(0.95, 0.95), causes = static_cast<int>(cases.causes().size());
    say("{} cases to answer, about {:.0f} min of computing in all ({:.0f} rows each)\n", left.size(),
        std::ceil(static_cast<double>(left.size()) * cases.rows() * seconds_per_row / 60), cases.rows());
    say("A promise of 95 % over the population needs {} cases, one for every cause {} ({} outcomes): share them "
        "out with --shard K/M, and give all files to diagnose.\n",
        needed, needed * causes, causes);
}

void tell_reached(const guarantee::Calibration& calibration)
{
    const auto promise = guarantee::promise_of(calibration, 0.95);
    if (!promise.kept)
        fmt::print("{}\n", too_few_cases_text(promise));
    else
        fmt::print("{} cases: a promise of 95 % {}\n", promise.cases,
                   promise.holds == CauseSet::Holds::every_cause ? "for every cause" : "over the population");
}

/// Answers one case as diagnose would.
guarantee::CalibrationCase answered(const guarantee::OwnCase& made, const Joint& joint, const guarantee::Place& place,
                                    const Invocation& invocation)
{
    guarantee::CalibrationCase c;
    c.truth = made.truth;
    c.place = place;
    const auto parallel = until_interrupted<gap::Interrupted>(invocation.interrupted, parallel_for_each);
    c.answer = answer_of(diagnose_made_records(joint, made.records, parallel));
    return c;
}

/// Everything that is known before the first case is made.
struct Work {
    Joint joint;
    guarantee::OwnCases cases;
    guarantee::Place place;
    guarantee::Calibration calibration;
    std::vector<int> left;  ///< numbers of the cases that this shard still has to answer
};

Work work_of(const Options& options)
{
    const Shard shard = shard_of(options.shard);
    const Joint joint = read_joint(options.joint);
    const auto given = gather_records(options.records, {options.joint, "", {}}, joint);
    if (!given.gaps.empty()) throw BadInput(given.gaps);
    auto cases = [&] {
        try {
            return guarantee::OwnCases(joint, given.records);
        } catch (const std::invalid_argument& e) {
            throw BadInput(options.joint + ": no cases can be made: " + refusal_text(e));
        }
    }();
    const auto population = fmt::format(
        "{} along its {} record{}, 2 to 10 % off its document, with one cause of the catalogue that makes 1.5 to 4 "
        "times "
        "the gap of the rest, or none",
        std::filesystem::path(options.joint).filename().string(), given.records.size(),
        given.records.size() == 1 ? "" : "s");
    Work work{joint,
              std::move(cases),
              place_among(joint, given.records),
              begun(options, {method_hash(), {population}, hash_of(joint), {}}),
              {}};
    for (int n = shard.number - 1; n < options.cases; n += shard.of)
        if (std::ranges::find(work.calibration.cases, name_of_case(options.seed, n, work.calibration.joint),
                              &guarantee::CalibrationCase::name) == work.calibration.cases.end())
            work.left.push_back(n);
    return work;
}

int run(const Options& options, const Invocation& invocation)
{
    const ThreadLimit limit(options.threads);
    Work work = work_of(options);
    auto& calibration = work.calibration;
    tell_plan(work.cases, work.left);
    write_whole(options.output, calibration_json(calibration));  // a full disk is reported before the work
    const auto start = std::chrono::steady_clock::now();
    std::size_t done = 0;
    for (const int n : work.left) {
        const auto made = work.cases.make(options.seed, static_cast<std::uint64_t>(n));
        const auto progress = fmt::format("{:>4}/{}  case {}", ++done, work.left.size(), n);
        if (invocation.interrupted) break;
        if (!made) {
            say("{}  its cause does not show in this motion, or cannot be simulated\n", progress);
            continue;
        }
        auto c = answered(*made, work.joint, work.place, invocation);
        if (invocation.interrupted) break;  // half an answer is none
        c.name = name_of_case(options.seed, n, calibration.joint);
        const double each =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / static_cast<double>(done);
        say("{}  {}  answered {}{}  about {:.0f} min left\n", progress,
            c.truth.effects.empty() ? "no effect" : c.truth.effects[0], c.answer.verdict,
            c.answer.ranked.empty() ? "" : fmt::format(" {}", fmt::join(c.answer.ranked[0], " + ")),
            std::ceil(each * static_cast<double>(work.left.size() - done) / 60));
        calibration.cases.push_back(std::move(c));
        write_whole(options.output, calibration_json(calibration));
    }
    tell_reached(calibration);
    fmt::print("calibration: {}\n", options.output);
    if (invocation.interrupted)
        say("interrupted: {} answered cases are kept; the same command goes on\n", calibration.cases.size());
    return invocation.interrupted ? exit_interrupted : exit_done;
}

}  // namespace

void add_calibrate(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb(
        "calibrate", "Calibrate diagnose --guarantee on your own joint: simulate cases of it and diagnose them");
    verb.add_option("JOINT", options->joint, "nominal joint, TOML, with control.period")->required();
    verb.add_option("RECORD", options->records, "its records, with reference_position: cases follow the same motions")
        ->required();
    verb.add_option("--cases", options->cases, "cases of all shards together")
        ->check(whole_between(1, 1000000))
        ->capture_default_str();
    verb.add_option("--shard", options->shard, "answer every M-th case only, from the K-th on: K/M")
        ->capture_default_str();
    verb.add_option("--seed", options->seed, "seed of the cases; case n does not depend on the number of cases")
        ->check(whole_number())
        ->capture_default_str();
    verb.add_option("-o,--output", options->output,
                    "file of the answered cases; cases that it holds are not answered again")
        ->capture_default_str();
    add_threads(verb, options->threads, "number of threads; 0: all cores; the answers do not depend on it");
    verb.footer(
        "Example: stickslip calibrate joint.toml slow.csv steps.csv --cases 59 -o calibration.json\n"
        "Example: stickslip calibrate joint.toml slow.csv --cases 1770 --shard 3/40 -o calibration-3.json\n"
        "Exit codes: 0 done, 2 bad input, 3 interrupted; finished cases are kept, and the same command continues.");
    verb.callback([options, &invocation] {
        catch_interrupts(invocation);
        invocation.exit_code = run(*options, invocation);
    });
}

}  // namespace stickslip
