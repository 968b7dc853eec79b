// The room of words as a stub of codes: linked before the real one, these stand in for the sentences below. What reads
// or decides by an answer must not notice: tests/schema/schema_test.py compares.
#include "sweep/words/boundary_text.h"
#include "sweep/words/cause_text.h"
#include "sweep/words/comparison_text.h"
#include "sweep/words/design_text.h"
#include "sweep/words/detail_text.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/experiment_text.h"
#include "sweep/words/export_text.h"
#include "sweep/words/integral_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/margins_text.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/neighbour_text.h"
#include "sweep/words/open_text.h"
#include "sweep/words/reason_text.h"
#include "sweep/words/robot_description_text.h"
#include "sweep/words/robot_text.h"
#include "sweep/words/set_point_design_text.h"
#include "sweep/words/set_point_text.h"
#include "sweep/words/signature_text.h"
#include "sweep/words/study_text.h"
#include "sweep/words/suspicion_text.h"
#include "sweep/words/timeline_text.h"
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

std::string ray_text(const Joint&, const LocatedRay&, const std::vector<IdleAxis>&)
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

std::string side_text(const GearSide&, bool)
{
    return "#side";
}

std::string signature_text(const std::vector<std::string>&)
{
    return "#signature";
}

std::string sheet_label(const std::string&)
{
    return "#sheet";
}

std::string impossible_inertia_text(const ImpossibleInertia&)
{
    return "#impossible-inertia";
}

std::string not_taken_text(const NotTaken&)
{
    return "#not-taken";
}

std::string suspected_unit_text(const SuspectedUnit&)
{
    return "#suspected-unit";
}

std::string beyond_limits_text(const PoseBeyondLimits&)
{
    return "#beyond-limits";
}

std::vector<std::string> unreachable_poses_text(const Joint&, const std::vector<Axis>&)
{
    return {"#unreachable-poses"};
}

std::string integral_text(const IntegralCost&, Units)
{
    return "#integral";
}

std::string left_out_text(const LoopUse&, double)
{
    return "#left-out-loop";
}

std::string why_text(WhyNot)
{
    return "#why-not";
}

std::string nearest_text(const NearestBoundary&, Units)
{
    return "#nearest";
}

std::string near_mode_text(const NearMode&, Units)
{
    return "#near-mode";
}

std::string remark_text(const Note& note)
{
    return "#" + std::string(name_of(note.code));
}

std::string suspicion_text(const Note& note)
{
    return remark_text(note);
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

std::string set_point_text(const SetPoint&, Units)
{
    return "#set-point";
}

std::string set_point_reason(SetPointReason)
{
    return "#set-point-reason";
}

std::string open_text(const NonlinearVerdict&)
{
    return "#open";
}

std::string contradicted_text(const std::vector<std::string>&, bool)
{
    return "#contradicted";
}

TakenOut taken_out(bool, const NonlinearVerdict&)
{
    return TakenOut::by_nothing;
}

std::string verdict_text(const Joint&, const LinearVerdict&, TakenOut, bool)
{
    return "#verdict";
}

std::string reason_text(Reason)
{
    return "#reason";
}

std::string reason_text(Reason, const Joint&)
{
    return "#reason-of-joint";
}

std::string reason_text(const NonlinearVerdict& verdict)
{
    if (verdict.detail != Detail::none) return "#" + std::string(name_of(verdict.detail));
    return verdict.reason == Reason::none ? "" : "#reason";
}

std::string detail_text(Detail detail)
{
    return detail == Detail::none ? "" : "#" + std::string(name_of(detail));
}

std::string larger_tried_text(LargerTried tried)
{
    return tried == LargerTried::none ? "" : "#" + std::string(name_of(tried));
}

std::string study_text(StudyReason reason)
{
    return "#" + std::string(name_of(reason));
}

std::string velocities_text(const std::vector<StudyReason>& reasons)
{
    return reasons.empty() ? "" : "#velocities";
}

std::string margins_reason_text(const std::vector<StudyReason>& reasons, double)
{
    return reasons.empty() ? "" : "#margins";
}

std::string refused_text(const ReductionStudy&)
{
    return "#refused";
}

std::string error_text(const ReductionStudy&)
{
    return "#error-of-reduction";
}

std::string rightmost_roots_text()
{
    return "#rightmost-roots";
}

std::string gap_left_text(const ExportAnswer&)
{
    return "#gap-left";
}

std::string lost_text(const ExportAnswer&, const NotExpressible& lost)
{
    return "#" + std::string(name_of(lost.why));
}

std::string design_verdict_text(const DesignAnswer&)
{
    return "#design-of-gains";
}

std::string design_text(const DesignAnswer&)
{
    return "#design-of-gains";
}

std::string set_point_design_text(const SetPointDesign&, Units)
{
    return "#design-of-set-point";
}

std::string way_text(SetPointWay way)
{
    return "#" + std::string(name_of(way));
}

std::string margins_text(const MarginsAnswer&)
{
    return "#margins";
}

std::string_view motion_text(TestMotion motion)
{
    return motion == TestMotion::none ? "" : "#motion";
}

std::string outcome_words(const DiagnosisFacts&)
{
    return "#outcome-of-diagnosis";
}

std::string comparison_sentence(const DiagnosisComparison&)
{
    return "#comparison";
}

std::string change_text(const NumberChange&)
{
    return "#change";
}

std::string regression_text(const GapRegression&, const DiagnosisComparison&)
{
    return "#regression";
}

std::string timeline_sentence(const Timeline&)
{
    return "#timeline";
}

}  // namespace stickslip
