// The room of words as a stub of codes: linked before the real one, these stand in for the sentences below. Those of
// sweeps, margins, designs, checks and comparisons have none and keep their words. What reads or decides by an answer
// must not notice: tests/schema/schema_test.py compares.
#include "sweep/words/boundary_text.h"
#include "sweep/words/cause_text.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/export_text.h"
#include "sweep/words/integral_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/neighbour_text.h"
#include "sweep/words/robot_text.h"
#include "sweep/words/set_point_text.h"
#include "sweep/words/verdict_text.h"

namespace stickslip {

std::string could_be_missed(const LocatedRay&)
{
    return "#could-be-missed-by-ray";
}

std::string could_be_missed(const FollowedBoundary&)
{
    return "#could-be-missed-by-curve";
}

std::string ray_text(const Joint&, const LocatedRay&)
{
    return "#ray";
}

std::string design_words(Region)
{
    return "#design";
}

std::string cause_text(const Cause&, const Joint&, const Joint&)
{
    return "#cause";
}

std::string integral_text(const IntegralCost&, Motion)
{
    return "#integral";
}

std::string why_text(WhyNot)
{
    return "#why-not";
}

std::string nearest_text(const NearestBoundary&, Motion)
{
    return "#nearest";
}

std::string near_mode_text(const NearMode&, Motion)
{
    return "#near-mode";
}

std::string remark_text(const Note& note)
{
    return "#" + std::string(name_of(note.code));
}

std::string note_text(const Note& note)
{
    return remark_text(note);
}

std::string robot_sentence(const RobotAnswer&)
{
    return "#robot";
}

std::string causes_words(const Diagnosis&)
{
    return "#causes";
}

std::string outcome_words(const JointOutcome&)
{
    return "#outcome";
}

std::string set_point_text(const SetPoint&, Motion)
{
    return "#set-point";
}

std::string set_point_reason(SetPointReason)
{
    return "#set-point-reason";
}

std::string verdict_text(const Joint&, const LinearVerdict&, bool)
{
    return "#verdict";
}

std::string reason_text(Reason)
{
    return "#reason";
}

}  // namespace stickslip
