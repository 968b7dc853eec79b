#include "sweep/files/json/robot_json.h"

#include "sweep/files/json/verdict_json.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/robot_text.h"

namespace stickslip {
namespace {

Json interval_json(const ConfidenceInterval& i)
{
    return Json::array({json_number(i.low), json_number(i.high)});
}

Json causes_json(const Diagnosis& d)
{
    Json causes = Json::array();
    for (const auto& cause : named_causes(d)) {
        Json parameters = Json::object();
        for (const auto& p : cause.parameters)
            parameters[p.name] = {
                {"value", json_number(p.value)}, {"stderr", json_number(p.standard_error)}, {"unit", p.unit}};
        causes.push_back({{"names", cause.names},
                          {"share", json_number(cause.share)},
                          {"interval", interval_json(cause.interval)},
                          {"probability", json_number(cause.probability)},
                          {"parameters", parameters}});
    }
    return causes;
}

/// What was found, from the joint's own diagnosis.json.
void add_diagnosis(const JointOutcome& joint, bool pages, Json& json)
{
    const Diagnosis& d = joint.diagnosis;
    json["verdict"] = name_of(d.verdict);
    if (d.interrupted) json["interrupted"] = true;
    json["reasons"] = Json::array(), json["reason_codes"] = Json::array();
    for (const auto& reason : d.reasons) {
        json["reasons"].push_back(note_text(reason));
        json["reason_codes"].push_back(name_of(reason.code));
    }
    json["causes"] = causes_json(d);
    json["ambiguous_with"] = d.ambiguous_with;
    json["corrected_share"] = json_number(d.corrected_share);
    json["remainder_share"] = json_number(d.remainder.share);
    json["gap"] = {{"before", json_number(d.overall.before)},
                   {"after", json_number(d.overall.after)},
                   {"floor", json_number(d.overall.floor)},
                   {"explained", json_number(d.overall.explained)}};
    json["diagnosis"] = joint.name + "/diagnosis.json";
    json["page"] = pages ? Json(joint.name + "/report.html") : Json();
    json["corrected_joint"] = joint.corrected ? Json(joint.name + "/corrected-joint.toml") : Json();
}

}  // namespace

Json robot_json(const RobotAnswer& robot, bool pages)
{
    Json json = {
        {"format", "stickslip-robot-diagnosis/1"}, {"title", robot.title}, {"sentence", robot_sentence(robot)}};
    json["interrupted"] = robot.interrupted;
    json["joints"] = Json::array();
    for (const auto& joint : robot.joints) {
        Json one = {{"name", joint.name}, {"file", joint.file}, {"status", name_of(joint.status)}};
        if (joint.status == JointOutcome::Status::refused) one["problems"] = joint.problems;
        if (joint.status == JointOutcome::Status::diagnosed) add_diagnosis(joint, pages, one);
        json["joints"].push_back(std::move(one));
    }
    return json;
}

}  // namespace stickslip
