// stickslip boundary: where exactly the boundaries lie.
#include "sweep/files/asked_axes.h"
#include "sweep/files/bad_input.h"
#include "sweep/files/boundary_json.h"
#include "sweep/files/whole_file.h"
#include "sweep/program.h"
#include "sweep/report/verdict_text.h"
#include "sweep/report/write_report.h"
#include "sweep/verbs/disturbance_option.h"
#include "sweep/verbs/parallel.h"
#include "sweep/verbs/verbs.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>

namespace stickslip {
namespace {

constexpr double default_start =
    1e-4;  ///< outcomes: V_0 is commanded from this share of itself, unless another is asked

struct Options {
    std::string input, directory;
    std::vector<std::string> kinds, along, over, settings;
    std::string disturbance;
    double size = missing, precision = not_set, max_undecided = 0.05;
    int guard = 16, threads = 0;
    bool json = false;
};

std::vector<BoundaryKind> kinds_from(const std::vector<std::string>& names)
{
    if (names.empty()) return {BoundaryKind::velocity_only, BoundaryKind::state_variable};
    std::vector<BoundaryKind> kinds;
    for (const auto& name : names)
        for (const auto kind : boundary_kinds)
            if (name_of(kind) == name) kinds.push_back(kind);
    return kinds;
}

Disturbance disturbance_from(const Options& options, const NonlinearSpec& spec)
{
    Disturbance d = spec.disturbance.disturbance;
    for (const auto& k : DisturbanceSpec::kinds)
        if (k.name == options.disturbance) d = {k.value, missing};
    if (is_set(options.size)) d.size = options.size;
    if (options.disturbance.empty() && !is_set(d.size)) d = {DisturbanceKind::start, default_start};
    if (d.kind == DisturbanceKind::start && is_set(d.size) && !(d.size >= 0))
        throw BadInput(fmt::format("--size: given is {:g}, allowed is a share of V0 to start from, ≥ 0", d.size));
    return d;
}

std::string text_of(const Disturbance& d, Motion motion)
{
    for (const auto& k : DisturbanceSpec::kinds)
        if (k.value == d.kind)
            return fmt::format("{}{}{}", k.name, is_set(d.size) ? fmt::format(" of {:g}", d.size) : " (small)",
                               d.kind == DisturbanceKind::start ? " V0"
                               : d.kind == DisturbanceKind::velocity
                                   ? fmt::format(" {}", unit_of(Quantity::velocity, motion))
                                   : "");
    return "";
}

/// The axes that a spec suggests where the command line names none.
void choose_axes(const Asked& asked, std::vector<Axis>& rays, std::vector<std::array<Axis, 2>>& charts)
{
    const auto& spec = asked.spec;
    if (spec.boundary && !spec.boundary->axis.empty()) {
        rays.push_back(axis_from(asked, spec.boundary->axis, "boundary.axis"));
        return;
    }
    if (spec.axes.empty()) rays.push_back(axis_from(asked, "control.k_p", "--along"));
    for (const auto& axis : spec.axes)
        if (axis.values.size() > 1) rays.push_back(axis_from(asked, axis.path, "--along"));
    for (const auto& [x, y] : spec.report.charts)
        charts.push_back({axis_from(asked, x, "--over"), axis_from(asked, y, "--over")});
}

int locate(const Options& options, const Invocation& invocation)
{
    const auto asked = read_spec_or_joint(options.input, options.settings);
    std::vector<Axis> rays;
    std::vector<std::array<Axis, 2>> charts;
    for (const auto& text : options.along) rays.push_back(axis_from(asked, text, "--along"));
    if (!options.over.empty())
        charts.push_back({axis_from(asked, options.over[0], "--over"), axis_from(asked, options.over[1], "--over")});
    if (rays.empty() && charts.empty()) choose_axes(asked, rays, charts);
    if (!charts.empty() && charts[0][0].path == charts[0][1].path)
        throw BadInput("--over: given is " + charts[0][0].path + " twice, wanted are two different axes");

    const ThreadLimit limit(options.threads);
    BoundaryRequest request;
    request.parallel = parallel_for_each;
    request.disturbance = disturbance_from(options, asked.spec.nonlinear);
    request.following.guard = options.guard;
    request.precision = is_set(options.precision) ? options.precision
                        : asked.spec.boundary     ? std::min(asked.spec.boundary->precision, 1e-4)
                                                  : not_set;
    BoundaryAnswer answer;
    answer.title = asked.spec.title;
    answer.command = invocation.command;
    answer.design = asked.design;
    answer.disturbance = request.disturbance;
    const auto start = std::chrono::steady_clock::now();
    for (const auto kind : kinds_from(options.kinds)) {
        request.kind = kind;
        BoundaryRequest own = request;
        // what a kind cannot reach is not asked of it
        if (!is_set(options.precision) && default_precision(kind) > 1e-9) own.precision = not_set;
        if (kind == BoundaryKind::v_min) {
            if (options.along.empty() && options.over.empty()) {
                answer.rays.push_back(locate_boundaries(asked.design, axis_from(asked, "control.V0", "--along"), own));
                continue;
            }
            for (const auto& axis : rays)
                if (axis.path != "control.V0")
                    throw BadInput("--along " + axis.path +
                                   ": the least velocity lies along control.V0; over another axis: --over " +
                                   axis.path + " control.V0");
        }
        for (const auto& axis : rays) answer.rays.push_back(locate_boundaries(asked.design, axis, own));
    }
    for (const auto& [x, y] : charts)
        for (const auto kind : kinds_from(options.kinds)) {
            request.kind = kind;
            BoundaryRequest own = request;
            if (!is_set(options.precision) && default_precision(kind) > 1e-9) own.precision = not_set;
            const bool named = !options.over.empty();
            if (kind == BoundaryKind::v_min && y.path != "control.V0" && !named) continue;
            if (kind == BoundaryKind::v_min && y.path != "control.V0")
                throw BadInput("--over " + x.path + " " + y.path + ": the least velocity needs control.V0 as y axis");
            answer.curves.push_back(follow_boundaries(asked.design, x, y, own));
        }
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;

    const auto json = boundary_json(answer);
    if (options.json) fmt::print("{}\n", json.dump(2));
    bool coarse = false, undecided = false;
    const auto judge = [&](int missing_verdicts, int nodes) {
        undecided = undecided || missing_verdicts > options.max_undecided * nodes;
    };
    int points = 0, evaluations = 0;
    for (const auto& ray : answer.rays) {
        judge(ray.undecided, ray.nodes);
        points += static_cast<int>(ray.points.size());
        evaluations += ray.evaluations;
        for (const auto& p : ray.points) coarse = coarse || !p.converged;
        if (options.json) continue;
        fmt::print("{}\n", plain_text(ray_text(answer.design, ray)));
        for (const auto& p : ray.points)
            fmt::print("  {:<14} {:<18.12g} {:<8} bracket {:.1e}  {}  {}, {} evaluations\n", name_of(ray.kind), p.value,
                       unit_of(ray.axis.quantity, answer.design.mechanism.motion), p.precision(),
                       p.converged ? "located" : "coarse ", name_of(p.method), p.evaluations);
        fmt::print("  could be missed: {}\n", could_be_missed(ray));
    }
    for (const auto& c : answer.curves) {
        judge(c.guard.undecided, c.guard.nodes);
        points += c.points();
        evaluations += c.evaluations;
        if (options.json) continue;
        fmt::print("{} over ({}, {}): {} pieces, {} points, coarsest bracket {:.1e}, {} evaluations\n", name_of(c.kind),
                   c.x.path, c.y.path, c.pieces.size(), c.points(), c.precision(), c.evaluations);
        for (const auto& piece : c.pieces)
            if (!piece.points.empty())
                fmt::print("  ({:.6g}, {:.6g}) … ({:.6g}, {:.6g}), {} points, ends: {}, {}\n", piece.points.front().x,
                           piece.points.front().y, piece.points.back().x, piece.points.back().y, piece.points.size(),
                           name_of(piece.first), name_of(piece.last));
        fmt::print("  could be missed: {}\n", could_be_missed(c));
    }
    if (!options.directory.empty()) {
        write_whole(std::filesystem::path(options.directory) / "boundary.json", json.dump(1) + "\n");
        write_whole(std::filesystem::path(options.directory) / "boundary.csv", boundary_csv(answer));
        const auto page = write_report(boundary_report(answer, parallel_for_each), options.directory);
        if (!options.json) fmt::print("report: {}\n", page.string());
    }
    if (!options.json) {
        for (const auto kind : kinds_from(options.kinds))
            if (kind == BoundaryKind::outcome)
                fmt::print("outcome means after the disturbance: {}\n",
                           text_of(answer.disturbance, answer.design.mechanism.motion));
        fmt::print("{} points, {} evaluations, {:.2f} s\n", points, evaluations, wall.count());
    }
    return coarse || undecided ? exit_undecided : exit_done;
}

}  // namespace

void add_boundary(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    std::vector<std::string> kinds, disturbances;
    for (const auto kind : boundary_kinds) kinds.emplace_back(name_of(kind));
    for (const auto& k : DisturbanceSpec::kinds) disturbances.emplace_back(k.name);
    auto* verb = app.add_subcommand(
        "boundary", "Locate boundaries along axes and over two of them: linear, folds of cycles, outcomes, V_min");
    verb->add_option("INPUT", options->input, "sweep spec or joint description, TOML")->required();
    verb->add_option("--kind", options->kinds, "kinds of boundary, one or more; default: velocity-only linear")
        ->check(CLI::IsMember(kinds));
    verb->add_option("--along", options->along,
                     "axes: PATH or PATH=FROM..TO, SI or with units, perhaps :log or :linear behind");
    verb->add_option("--over", options->over, "two axes, x then y, each as in --along")->expected(2);
    verb->add_option("--set", options->settings, "change a number first: path=value");
    verb->add_option("--disturbance", options->disturbance,
                     "what an outcome means; default: that of the spec, else a start from V0/10⁴")
        ->check(CLI::IsMember(disturbances));
    verb->add_option("--size", options->size,
                     "of the disturbance: m, m/s, N·s, N (rad, …); for start: the share of V0 from which V0 is "
                     "commanded")
        ->check(finite_number());
    verb->add_option("--precision", options->precision,
                     "relative width of brackets; default: 1e-10 linear, 1e-6 fold, 1e-4 outcome")
        ->check(finite_number())
        ->check(CLI::Range(1e-12, 0.1));
    verb->add_option("--guard", options->guard, "cells along each axis of the grid that guards against missed pieces")
        ->check(CLI::Range(2, 512))
        ->capture_default_str();
    verb->add_option("-o,--output", options->directory, "write boundary.json, boundary.csv and report.html here");
    verb->add_option("--threads", options->threads, "0: all cores")->capture_default_str();
    verb->add_option("--max-undecided", options->max_undecided,
                     "exit 4 if a larger share of the scanned points has no verdict")
        ->capture_default_str();
    verb->add_flag("--json", options->json, "print boundary.json instead of text");
    verb->footer(
        "Examples:\n"
        "  stickslip boundary examples/02-ball-screw/joint-with-memory.toml --along control.k_p=1e3..1e7\n"
        "  stickslip boundary examples/03-bistable-strip/spec.toml --kind linear fold --over control.k_p control.k_v "
        "-o "
        "out\n"
        "  stickslip boundary joint.toml --kind v-min --along 'control.V0=1 um/s..10 mm/s'\n"
        "Exit codes: 0 answered (also: no boundary there), 2 bad input, 4 a point is coarser than asked for or too "
        "many "
        "points have no verdict.");
    verb->callback([options, &invocation] { invocation.exit_code = locate(*options, invocation); });
}

}  // namespace stickslip
