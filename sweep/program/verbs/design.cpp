// stickslip design: the best gains under requirements.
#include "analysis/joint/gains.h"
#include "analysis/simulation/simulate.h"
#include "analysis/stability/frequency_search.h"
#include "analysis/stability/verdict.h"
#include "sweep/files/json/design_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/files/toml/changed_lines.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/requirements_file.h"
#include "sweep/program/verbs/design_set_point.h"
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
#include "sweep/report/pages/design_report.h"
#include "sweep/report/write_report.h"
#include "sweep/words/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace stickslip {
namespace {

struct Options {
    std::string input, directory;
    std::vector<std::string> settings, requirements;
    int threads = 0;
    double effort = 1;
    bool json = false, holds = false, ideal_loop = false;  ///< holds: --set-point
    SetPointOptions set_point;
};

/// Around the range that was searched and every choice that is compared.
std::optional<GainChart> map_of_choices(const DesignAnswer& answer, const Joint& best)
{
    constexpr double beside = 2;  // beyond the outermost, as a factor
    Interval k_p = answer.range.k_p, k_v = answer.range.k_v;
    for (Interval* range : {&k_p, &k_v})  // from zero on: from the least choice on, on a logarithmic axis
        if (!(range->low > 0)) range->low = range->high;
    const auto take = [](Interval& range, double value) {
        if (value > 0 && std::isfinite(value)) range = {std::min(range.low, value), std::max(range.high, value)};
    };
    const auto& d = answer.design;
    for (const auto& [p, v] : {std::pair{d.best.k_p, d.best.k_v},
                               {d.velocity_only.k_p, d.velocity_only.k_v},
                               {answer.joint.control.k_p, answer.joint.control.k_v}})
        take(k_p, p), take(k_v, v);
    return gain_chart_over(best, {k_p.low / beside, k_p.high * beside}, {k_v.low / beside, k_v.high * beside});
}

/// design.json, the joint file with the new gains, and the page.
void write_files(const DesignAnswer& answer, const Joint& described, const nlohmann::ordered_json& json,
                 const Options& options)
{
    write_whole(std::filesystem::path(options.directory) / "design.json", json.dump(1) + "\n");
    std::vector<Snippet> snippets;
    if (answer.design.feasible) {
        // gains of the ideal loop go into the file as it is
        const Joint before = described.control.structure == Structure::pid ? described : answer.joint;
        Joint best = before;
        // as many digits as the page prints, and two more
        const auto typed = [](double gain) { return std::stod(fmt::format("{:.6g}", gain)); };
        best.control.k_p = typed(answer.design.best.k_p), best.control.k_v = typed(answer.design.best.k_v);
        const auto text = joint_text(best);
        write_whole(std::filesystem::path(options.directory) / "designed-joint.toml", text);
        snippets = {{"For the joint file", changed_lines(joint_text(before), text), ""},
                    {"The whole joint file with these gains", text, "designed-joint.toml"}};
    }
    const auto page = write_report(with_version(design_report(answer, std::move(snippets))), options.directory);
    if (!options.json) fmt::print("\nreport: {}\n", page.string());
}

int design(const Options& options, const Invocation& invocation)
{
    auto asked = read_spec_or_joint(options.input, options.settings);
    const Joint described = asked.design;  // whose sensors and limits the requirements are of, in any loop
    std::optional<LeftOutLoop> left_out = options.ideal_loop ? leave_loop_out(asked) : std::nullopt;
    say_no_sliding(options.input, options.settings, asked.design);
    DesignAnswer answer;
    answer.title = asked.spec.title;
    answer.command = invocation.command;
    answer.joint = asked.design;
    answer.loop = verdict_loop(answer.joint);
    answer.left_out = std::move(left_out);
    answer.requirements = read_requirements(options.input, described, options.requirements);
    const ThreadLimit limit(options.threads);
    set_search_effort(options.effort);
    std::optional<StageLine> line(std::in_place, searches_less(options.effort), std::chrono::seconds(1));
    try {
        answer.range = gain_range(answer.joint, answer.requirements);
        answer.design = design_gains(answer.joint, answer.requirements, line->counted(parallel_for_each),
                                     [&](DesignStage stage) { line->stage(stage_text(stage)); });
    } catch (const std::invalid_argument& e) {
        throw BadInput(fmt::format("{}: requirements.{}", options.input, e.what()));
    }
    if (answer.design.decided) {
        line->stage("the nearest boundary of these gains");
        Joint best = answer.joint;
        best.control.k_p = answer.design.best.k_p, best.control.k_v = answer.design.best.k_v;
        answer.uncertain =
            answer.requirements.uncertain.empty() ? friction_coordinates(best) : answer.requirements.uncertain;
        answer.nearest = nearest_boundary(best, answer.uncertain, affordable_search(best));
        answer.margin_tolerance = tolerance_each(answer.design.best.margin, answer.uncertain);
        if (options.ideal_loop) {
            Joint real = described.control.structure == Structure::pid ? described : with_gains(described);
            real.control.k_p = best.control.k_p, real.control.k_v = best.control.k_v;
            answer.left_out = left_out_loop(real);
        }
        if (!options.directory.empty()) {  // only the page shows them
            line->stage("what its page draws");
            answer.map = map_of_choices(answer, best);
            answer.motion = simulate(best, {});
            answer.motion_before = simulate(answer.joint, {});
        }
    }
    line.reset();
    const auto json = design_json(answer);
    if (options.json) {
        fmt::print("{}\n", json.dump(2));
    } else {
        print_sentence(design_text(answer));
        for (const auto& table : design_tables(answer)) print_table(table);
        if (!answer.design.front.empty()) print_table(front_table(answer));
    }
    if (!options.directory.empty()) write_files(answer, described, json, options);
    return !answer.design.decided ? exit_undecided : answer.design.feasible ? exit_done : exit_not_met;
}

void add_set_point_options(Verb& verb, Option& holds, SetPointOptions& held)
{
    verb.add_option("--over", held.over, "with --set-point: what may be changed; default: all four")
        ->check(one_of({"control.k_i", "control.dead_zone", "push", "control.dither"}))
        ->needs(holds);
    verb.add_option("--friction-margin", held.friction_margin,
                    "with --set-point: relative uncertainty of static and of kinetic friction")
        ->check(between(0, 0.99))
        ->capture_default_str()
        ->needs(holds);
    verb.add_option("--integral-gain", held.integral_gain,
                    "with --set-point: k_i of the variants with integral action; default: that of the joint")
        ->check(positive_number())
        ->needs(holds);
    verb.add_option(
            "--push-speed", held.push_speed,
            "with --set-point: velocity over which the compensation fades; default: control.feed_forward.coulomb_speed")
        ->check(positive_number())
        ->needs(holds);
    verb.add_option("--rest-error", held.rest_error, "with --set-point: largest permitted error at rest")
        ->check(not_negative_number())
        ->needs(holds);
}

}  // namespace

void add_design(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb =
        line.add_verb("design", "Best k_p and k_v under noise, effort, margin and velocity requirements; Pareto front");
    verb.add_option("INPUT", options->input, "sweep spec or joint description, TOML, with [requirements]")->required();
    verb.add_option("--set", options->settings, "set a parameter of the joint first: path=value");
    verb.add_option("--require", options->requirements,
                    "change a requirement: key=value; keys: objective (motion | effort), position_noise [m], "
                    "velocity_noise [m/s], sample_time [s], filter [s], average, effort_limit [N], noise_multiple, "
                    "margin, least_velocity [m/s], stiffness_scale [N/m], k_p_from, k_p_to [N/m], k_v_from, k_v_to "
                    "[N·s/m], front_points; rad, N·m for revolute joints; values may carry units");
    verb.add_option("-o,--output", options->directory, "write design.json, designed-joint.toml and report.html here");
    add_threads(verb, options->threads, "number of threads; 0: all cores")->capture_default_str();
    verb.add_option("--effort", options->effort,
                    "multiple of the usual search effort: how many gains are tried, and in how many directions")
        ->check(positive_number());
    auto ideal = verb.add_flag("--ideal-loop", options->ideal_loop,
                               "the paper's loop: no sampling, dead time, filter, lag or integral");
    verb.add_flag("--json", options->json, "print design.json instead of text");
    auto holds =
        verb.add_flag(
                "--set-point", options->holds,
                "instead, find how to hold a set point without hunting: k_i, dead zone, friction compensation, dither")
            ->excludes(ideal);
    add_set_point_options(verb, holds, options->set_point);
    verb.footer(
        "Examples:\n"
        "  stickslip design examples/04-design/spec.toml -o out\n"
        "  stickslip design joint.toml --require 'position_noise=1 um' --require sample_time=1e-3 --require "
        "margin=0.2\n"
        "  stickslip design examples/08-hunting-arm/joint.toml --set-point --friction-margin 0.05\n"
        "Exit codes: 0 feasible, 1 no gains meet the requirements (the answer says what would be feasible), 2 bad "
        "input, 3 interrupted, 4 no verdict.");
    verb.callback([options, &invocation] {
        auto& asked = options->set_point;
        asked.input = options->input, asked.directory = options->directory, asked.settings = options->settings;
        asked.threads = options->threads, asked.json = options->json;
        invocation.exit_code =
            options->holds ? design_set_point_answer(asked, invocation) : design(*options, invocation);
    });
}

}  // namespace stickslip
