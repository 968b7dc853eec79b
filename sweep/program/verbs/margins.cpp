// stickslip margins: how far a design is from its boundaries.
#include "analysis/stability/frequency_search.h"
#include "sweep/files/json/margins_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/files/toml/requirements_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/left_out.h"
#include "sweep/program/verbs/no_sliding.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/stage_line.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/program/verbs/with_version.h"
#include "sweep/program/verbs/word_option.h"
#include "sweep/report/pages/margins_report.h"
#include "sweep/report/write_report.h"
#include "sweep/study/robust_set.h"
#include "sweep/words/plain_text.h"

#include <fmt/format.h>

#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::string input, directory, shape = "box";
    std::vector<std::string> settings, uncertain, over;
    int guard = 12, threads = 0;
    double effort = 1;
    bool json = false, ideal_loop = false;
};

MarginsAnswer answered(const Options& options, const std::string& command)
{
    auto asked = read_spec_or_joint(options.input, options.settings);
    const auto left_out = options.ideal_loop ? leave_loop_out(asked) : std::nullopt;
    say_no_sliding(options.input, options.settings, asked.design);
    set_search_effort(options.effort);
    StageLine line(searches_less(options.effort), std::chrono::seconds(1));
    line.stage("the nearest boundary in all directions");
    auto answer = margins_of(asked.design);
    answer.title = asked.spec.title;
    answer.command = command;
    answer.left_out = left_out;
    if (!options.uncertain.empty()) {
        answer.uncertainty = uncertainty_from(asked.design, options.uncertain);
        if (options.shape == "ellipsoid") answer.uncertainty.shape = UncertaintyShape::ellipsoid;
        line.stage("the worst joint within the uncertainty");
        answer.idle = idle_coordinates(asked.design, answer.uncertainty);
        answer.worst = worst_case(asked.design, answer.uncertainty, Curve::Kind::state_variable);
    }
    if (!options.over.empty()) {
        if (options.uncertain.empty())
            throw BadInput("--over: the robustly stable set needs --uncertain PATH=SHARE, such as friction.L=20%");
        const Axis x = axis_from(asked, options.over[0], "--over"), y = axis_from(asked, options.over[1], "--over");
        if (x.path == y.path) throw BadInput("--over: got " + x.path + " twice, expected two different axes");
        if (options.ideal_loop) refuse_left_out(asked.design, {x, y});
        for (auto& axis : idle_axes(asked.design, {x, y}))
            if (!idle_axis(answer.idle, axis.path)) answer.idle.push_back(std::move(axis));
        line.stage("the set that is stable for all joints within the uncertainty");
        BoundaryRequest request;
        request.parallel = parallel_for_each;
        request.following.guard = options.guard;
        answer.robust = follow_robust_boundary(asked.design, x, y, answer.uncertainty, request);
        answer.nominal = follow_boundaries(asked.design, x, y, request);
    }
    if (!options.directory.empty()) {
        line.stage("growth along each parameter");
        answer.growth = growth_by_parameter(answer);
        if (answer.robust && answer.nominal) answer.robust_set = robust_set(answer);
    }
    return answer;
}

int margins(const Options& options, const Invocation& invocation)
{
    const ThreadLimit limit(options.threads);
    const auto answer = answered(options, invocation.command);
    const auto json = margins_json(answer);
    if (options.json)
        fmt::print("{}\n", json.dump(2));
    else
        print_sentence(margins_text(answer)), fmt::print("{}", alone_lines(answer));
    if (!options.directory.empty()) {
        write_whole(std::filesystem::path(options.directory) / "margins.json", json.dump(1) + "\n");
        const auto page = write_report(with_version(margins_report(answer)), options.directory);
        if (!options.json) fmt::print("report: {}\n", page.string());
    }
    return answer.nearest.decided ? exit_done : exit_undecided;
}

}  // namespace

void add_margins(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb(
        "margins", "Distance of a design from its boundaries: nearest in all directions, one by one, worst case");
    verb.add_option("INPUT", options->input, "sweep spec or joint description, TOML")->required();
    verb.add_option("--set", options->settings, "set a parameter first: path=value");
    verb.add_option("--uncertain", options->uncertain,
                    "uncertainty of parameters: PATH=20%, 'friction.B - friction.A=10%'");
    verb.add_option("--shape", options->shape, "shape of the uncertainty: box, or an ellipsoid within it")
        ->check(one_of({"box", "ellipsoid"}))
        ->capture_default_str();
    verb.add_option("--over", options->over,
                    "two axes over which the robustly stable set is followed: PATH or PATH=FROM..TO")
        ->expected(2);
    verb.add_option("--guard", options->guard, "cells along each axis of the grid that searches for further pieces")
        ->check(whole_between(2, 512))
        ->capture_default_str();
    verb.add_option("-o,--output", options->directory, "write margins.json and report.html here");
    add_threads(verb, options->threads, "number of threads; 0: all cores")->capture_default_str();
    verb.add_option("--effort", options->effort, "multiple of the usual work of a search for crossings")
        ->check(positive_number());
    add_ideal_loop(verb, options->ideal_loop);
    verb.add_flag("--json", options->json, "print margins.json instead of text");
    verb.footer(
        "Example: stickslip margins examples/01-reference-joint/spec.toml --uncertain friction.L=20% --uncertain "
        "'friction.B - friction.A=10%' --over control.k_p control.k_v -o out\n"
        "Exit codes: 0 answered, 2 bad input, 4 the joint has no verdict.");
    verb.callback([options, &invocation] { invocation.exit_code = margins(*options, invocation); });
}

}  // namespace stickslip
