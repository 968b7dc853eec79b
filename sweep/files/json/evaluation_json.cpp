#include "sweep/files/json/evaluation_json.h"

#include "sweep/files/json/load_json.h"
#include "sweep/files/json/nonlinear_json.h"
#include "sweep/files/json/set_point_json.h"
#include "sweep/files/json/study_json.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/reason_text.h"

namespace stickslip {
namespace {

nlohmann::ordered_json forced_json(const AskedDisturbance& asked, const DisturbedMotion& motion)
{
    return {{"kind", asked.kind},
            {"size", asked.size},
            {"duration", motion.memory.time.back()},
            {"peak", motion.peak},
            {"peak_time", motion.peak_time},
            {"final", motion.memory.position.back()}};
}

}  // namespace

nlohmann::ordered_json evaluation_json(const JointEvaluation& e, const std::string& servo)
{
    nlohmann::ordered_json json = {{"format", "stickslip-evaluate/1"}, {"decided", e.answered()}};
    json.update(verdict_json(e.verdict));
    const auto open = e.verdict.steady.reason;
    if (open != Reason::none) json["reason"] = reason_text(open, e.joint);
    json["loop"] = loop_json(e.verdict.loop, e.left_out);
    if (e.decided()) json["linear"].update(study_json(*e.study, e.locus));
    if (e.motion) json["linear"]["forced"] = forced_json(e.force, *e.motion);
    if (e.loads) json["linear"]["normal_load"] = load_json(*e.loads);
    json["nonlinear"] = nonlinear_json(e.nonlinear);
    json["contradicting_terms"] = e.contradicting;
    for (const auto& mode : e.near)
        json["warnings"].push_back({{"code", "neighbour-mode"},
                                    {"neighbour", mode.neighbour},
                                    {"omega", mode.omega},
                                    {"friction_omega", mode.friction}});
    if (e.rest) json["set_point"] = set_point_json(*e.rest);
    if (e.integral)
        json["linear"]["integral_cost"] = {
            {"margin", e.integral->with}, {"margin_without", e.integral->without}, {"share", e.integral->share()}};
    if (e.left_out) {
        json["notes"].push_back(left_out_text(e.left_out->loop, e.left_out->growth));
        json["note_codes"].push_back("ideal-loop");
    }
    if (!servo.empty()) json["notes"].push_back(servo), json["note_codes"].push_back("servo");
    return json;
}

}  // namespace stickslip
