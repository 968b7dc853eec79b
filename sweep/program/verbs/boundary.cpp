// stickslip boundary: where exactly the boundaries lie.
#include "analysis/boundary/kinds/linear_side.h"
#include "analysis/boundary/kinds/outside.h"
#include "analysis/results/text.h"
#include "analysis/simulation/set_point/set_point.h"
#include "analysis/stability/verdict.h"
#include "sweep/files/json/boundary_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/program/verbs/boundary_question.h"
#include "sweep/program/verbs/disturbance_option.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/left_out.h"
#include "sweep/program/verbs/no_sliding.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/stage_line.h"
#include "sweep/program/verbs/stoppable.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/program/verbs/with_version.h"
#include "sweep/program/verbs/word_option.h"
#include "sweep/report/pages/boundary_report.h"
#include "sweep/report/write_report.h"
#include "sweep/study/boundary_charts.h"
#include "sweep/words/boundary_text.h"
#include "sweep/words/plain_text.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>

namespace stickslip {
namespace {

void answer_one(BoundaryAnswer& answer, BoundaryRequest request, const std::vector<Axis>& axes,
                const Invocation& invocation)
{
    request.parallel = until_interrupted(invocation.interrupted, request.parallel);
    if (request.kind == BoundaryKind::outcome)
        answer.outcome_means = disturbance_text(request.disturbance, units_of(answer.design));
    if (axes.size() == 2) {
        answer.curves.push_back(follow_boundaries(answer.design, axes[0], axes[1], request));
        return;
    }
    auto ray = locate_boundaries(answer.design, axes[0], request);
    if (beyond_ray(answer.design, ray)) answer.region = Region::bistable;
    const bool at_rest = request.kind == BoundaryKind::hunting;
    if (at_rest && ray.points.empty())
        if (auto same = idle_at_rest(answer.design, ray.axis)) answer.idle.push_back(std::move(*same));
    const bool idle = (is_linear(request.kind) || at_rest) && idle_axis(answer.idle, axes[0].path, at_rest);
    if (ray.points.empty() && ray.undecided < ray.nodes && !idle)
        ray.outside = nearest_outside(answer.design, ray, request);
    answer.rays.push_back(std::move(ray));
}

std::string stage_of(const BoundaryRequest& request, const std::vector<Axis>& axes)
{
    return fmt::format("the {} boundary {} {}{}", name_of(request.kind), axes.size() == 2 ? "over" : "along",
                       axes[0].path, axes.size() == 2 ? " and " + axes[1].path : "");
}

/// Returns how many questions were answered before a stop was requested. What lies under the curves comes last.
std::size_t answer_all(BoundaryAnswer& answer, const std::vector<BoundaryQuestion>& questions,
                       const Invocation& invocation)
{
    std::size_t answered = 0;
    StageLine line("", std::chrono::seconds(1));
    try {
        for (const auto& [request, axes] : questions) {
            if (invocation.interrupted) throw Stopped();
            line.stage(stage_of(request, axes));
            answer_one(answer, request, axes, invocation);
            ++answered;
        }
        line.stage("the regions under the curves");
        answer.charts =
            boundary_charts(answer.design, answer.curves, until_interrupted(invocation.interrupted, parallel_for_each));
        for (const auto& chart : answer.charts)
            if (chart.sliding && chart.sliding->design.region == Region::bistable) answer.region = Region::bistable;
    } catch (const Stopped&) {
        say("interrupted: {} of {} boundaries were located{}\n", answered, questions.size(),
            answered == questions.size() ? " and are kept; the regions under their curves are left out"
            : answered > 0               ? " and are kept; the others are left out"
                                         : "; nothing was written");
    }
    answer.meetings = meetings_of(answer.design, answer.rays, answer.curves);
    return answered;
}

/// What all boundaries of an answer come to.
struct Tally {
    int points = 0, evaluations = 0;
    bool coarse = false, undecided = false;

    Tally(const BoundaryAnswer& answer, double max_undecided)
    {
        const auto judge = [&](int missing_verdicts, int nodes) {
            undecided = undecided || missing_verdicts > max_undecided * nodes;
        };
        for (const auto& ray : answer.rays) {
            judge(ray.undecided, ray.nodes);
            points += static_cast<int>(ray.points.size());
            evaluations += ray.evaluations;
            for (const auto& p : ray.points) coarse = coarse || !p.converged;
        }
        for (const auto& c : answer.curves) {
            judge(c.guard.undecided, c.guard.nodes);
            points += c.points();
            evaluations += c.evaluations;
        }
    }
};

void print_ray(const LocatedRay& ray, Units units)
{
    fmt::print("{} along {}: {}, {} evaluations\n", name_of(ray.kind), ray.axis.path,
               counted(ray.points.size(), "point"), ray.evaluations);
    for (const auto& p : ray.points)
        fmt::print("  {:<14} {:<18.12g} {:<8} bracket {:.1e}  {}  {}, {} evaluations\n", name_of(ray.kind), p.value,
                   unit_of(ray.axis.quantity, units), p.precision(), p.converged ? "located" : "coarse ",
                   name_of(p.method), p.evaluations);
    fmt::print("  not excluded by this search: {}\n", could_be_missed(ray));
}

void print_curve(const FollowedBoundary& c, Units units)
{
    const auto place = [&](const auto& point) {
        return plain_text("(" + with_unit(point.x, c.x.quantity, units, 6) + ", " +
                          with_unit(point.y, c.y.quantity, units, 6) + ")");
    };
    fmt::print("{} over ({}, {}): {}, {} points, coarsest bracket {:.1e}, {} evaluations\n", name_of(c.kind), c.x.path,
               c.y.path, counted(c.pieces.size(), "piece"), c.points(), c.precision(), c.evaluations);
    for (const auto& piece : c.pieces)
        if (!piece.points.empty())
            fmt::print("  {} … {}, {} points, ends: {}, {}\n", place(piece.points.front()), place(piece.points.back()),
                       piece.points.size(), name_of(piece.first), name_of(piece.last));
    fmt::print("  not excluded by this search: {}\n", could_be_missed(c));
}

int locate(const BoundaryOptions& options, const Invocation& invocation)
{
    const auto start = std::chrono::steady_clock::now();
    auto asked = read_spec_or_joint(options.input, options.settings);
    const auto left_out = options.ideal_loop ? leave_loop_out(asked) : std::nullopt;
    say_no_sliding(options.input, options.settings, asked.design);
    const auto questions = boundary_questions(asked, options);
    if (options.ideal_loop)
        for (const auto& question : questions) refuse_left_out(asked.design, question.axes);
    const ThreadLimit limit(options.threads);
    BoundaryAnswer answer;
    answer.title = asked.spec.title;
    answer.command = invocation.command;
    answer.design = asked.design;
    answer.left_out = left_out;
    answer.loop = verdict_loop(answer.design);
    for (const auto& question : questions)
        if (question.request.kind == BoundaryKind::hunting) answer.set_point = set_point(answer.design);
    answer.idle = idle_axes(answer.design, linear_axes(questions));
    answer.region = linear_region(answer.design);
    const std::size_t answered = answer_all(answer, questions, invocation);
    if (answered == 0 && !questions.empty()) return exit_interrupted;
    const auto report = with_version(boundary_report(answer));
    auto json = boundary_json(answer);
    json["answer"] = plain_text(report.verdict);
    if (options.json)
        fmt::print("{}\n", json.dump(2));
    else
        print_sentence(report.verdict);
    const Tally tally(answer, options.max_undecided);
    if (!options.json) {
        for (const auto& ray : answer.rays) print_ray(ray, units_of(answer.design));
        for (const auto& curve : answer.curves) print_curve(curve, units_of(answer.design));
    }
    if (!options.directory.empty()) {
        write_whole(std::filesystem::path(options.directory) / "boundary.json", json.dump(1) + "\n");
        write_whole(std::filesystem::path(options.directory) / "boundary.csv", boundary_csv(answer));
        const auto page = write_report(report, options.directory);
        if (!options.json) fmt::print("report: {}\n", page.string());
    }
    if (!options.json) {
        if (!answer.outcome_means.empty())
            fmt::print("outcomes follow a disturbance: {}\n", plain_text(answer.outcome_means));
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        fmt::print("{}, {} evaluations, {:.2f} s\n", counted(tally.points, "point"), tally.evaluations, seconds);
    }
    const bool bare = answer.charts.empty() && !answer.curves.empty();
    if (answered < questions.size() || bare) return exit_interrupted;
    return tally.coarse || tally.undecided ? exit_undecided : exit_done;
}

}  // namespace

void add_boundary(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<BoundaryOptions>();
    std::vector<std::string> kinds, disturbances;
    for (const auto kind : boundary_kinds) kinds.emplace_back(name_of(kind));
    for (const auto& k : DisturbanceSpec::kinds) disturbances.emplace_back(k.name);
    auto verb = line.add_verb(
        "boundary", "Locate boundaries along axes and over two of them: linear, folds of cycles, outcomes, V_min");
    verb.add_option("INPUT", options->input, "sweep spec or joint description, TOML")->required();
    verb.add_option("--kind", options->kinds, "kinds of boundary, one or more; default: velocity-only linear")
        ->check(one_of(kinds));
    verb.add_option("--along", options->along,
                    "axes: PATH or PATH=FROM..TO, SI or with units, optionally followed by :log or :linear");
    verb.add_option("--over", options->over, "two axes, x then y, each as in --along")->expected(2);
    verb.add_option("--set", options->settings, "set a parameter first: path=value");
    verb.add_option("--disturbance", options->disturbance,
                    "disturbance that decides the outcome; default: that of the spec, else a start from V0/10⁴")
        ->check(one_of(disturbances));
    verb.add_option(
            "--size", options->size,
            "size of the disturbance: m, m/s, N·s, N (rad, …); for start: the share of V0 from which V0 is commanded")
        ->check(finite_number());
    verb.add_option("--precision", options->precision,
                    "relative width of brackets; default: 1e-10 linear, 1e-6 fold (3e-4 by simulation), 1e-4 outcome")
        ->check(between(1e-12, 0.1));
    verb.add_option("--guard", options->guard,
                    "cells along each axis of the grid that searches for further pieces; default: 16, or 8 if each "
                    "point is a simulation")
        ->check(whole_between(2, 512));
    verb.add_option("-o,--output", options->directory, "write boundary.json, boundary.csv and report.html here");
    add_threads(verb, options->threads, "number of threads; 0: all cores")->capture_default_str();
    verb.add_option("--max-undecided", options->max_undecided,
                    "exit 4 if more than this share of the scanned points has no verdict")
        ->check(between(0, 1))
        ->capture_default_str();
    add_ideal_loop(verb, options->ideal_loop);
    verb.add_flag("--json", options->json, "print boundary.json instead of text");
    verb.footer(
        "Examples:\n"
        "  stickslip boundary examples/02-ball-screw/joint-with-memory.toml --set control.k_v=0 --along "
        "control.k_p=1e3..1e7\n"
        "  stickslip boundary examples/03-bistable-strip/spec.toml --kind linear fold --over control.k_p control.k_v "
        "-o "
        "out\n"
        "  stickslip boundary joint.toml --kind v-min --along 'control.V0=1 um/s..10 mm/s'\n"
        "A [boundary] table in the spec has the same options: kind, along, over, guard, precision.\n"
        "Exit codes: 0 answered (also: no boundary there), 2 bad input, 3 interrupted: what was located is kept, 4 a "
        "point is coarser than requested, or too many points have no verdict.");
    verb.callback([options, &invocation] {
        catch_interrupts(invocation);
        invocation.exit_code = locate(*options, invocation);
    });
}

}  // namespace stickslip
