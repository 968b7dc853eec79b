#include "sweep/study/diagnose.h"

#include "analysis/diagnosis/diagnose.h"
#include "analysis/diagnosis/plant/record_form.h"
#include "analysis/diagnosis/rig/rig.h"

namespace stickslip {

JointDiagnosis diagnose_records(const Joint& documented, const std::vector<Record>& records,
                                const std::vector<Note>& contradictions, const ParallelFor& parallel,
                                const StageProgress& progress)
{
    // a rig fits laws as they are
    const bool of_rig = gap::is_rig(records.front());
    const Joint joint = of_rig ? documented : gap::record_form(documented);
    JointDiagnosis found{{}, joint, joint, {}, !contradictions.empty(), of_rig};
    Diagnosis& d = found.diagnosis;
    if (found.contradicted) {
        d.motion = joint.mechanism.motion;
        d.reasons = contradictions;
    } else {
        gap::DiagnosisOptions settings;
        settings.progress = progress;
        auto result = gap::diagnose(joint, records, parallel, settings);
        d = std::move(result.diagnosis);
        found.after = result.after;
    }
    found.windows = {own_windows(found.before, d.usual_speed), own_windows(found.after, d.usual_speed)};
    return found;
}

Diagnosis diagnose_made_records(const Joint& joint, const std::vector<Record>& records, const ParallelFor& parallel)
{
    return gap::diagnose(joint, records, parallel).diagnosis;
}

}  // namespace stickslip
