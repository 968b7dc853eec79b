#include "analysis/simulation/lanes/ticked_program.h"

#include <cmath>
#include <optional>

#include "analysis/joint/drive.h"
#include "analysis/numerics/hermite.h"
#include "analysis/simulation/flows/near_rest.h"
#include "analysis/simulation/lanes/dense_output.h"
#include "analysis/simulation/lanes/grouping.h"
#include "analysis/simulation/sampled/loop_verdict.h"

namespace stickslip::lanes {
namespace {

constexpr double rough = 1e-5;   ///< tolerance of turns on the way to an end, as of the ideal loop's lanes
constexpr long told_every = 16;  ///< ticks after which extrema between two turns reach who waits for a turn

}  // namespace

/// One verdict on its way: its motions, and the joint of the present one in the units of the lanes.
class TickedProgram::Lane {
  public:
    explicit Lane(const TickedJob& job)
        : job_(job), inquiry_(*job.joint, *job.question, GrowthBy::theory), actuator_(job.joint->actuator)
    {
    }

    bool start(TickedJoint& joint, TickedPiece& first);
    bool arrive(const double* y, const TickedPassage& passed, TickedPiece& next);
    void event(const TickedStep& step, const TickedPassage& before);

  private:
    bool finished();
    void open_tick(TickedPiece& piece);
    void fill(double length, TickedPiece& piece);
    void take(const TickedPassage& passed);
    void tell();
    double effort_in_excess(double command) const;

    TickedJob job_;
    LoopInquiry inquiry_;
    const Actuator& actuator_;
    double frame_ = 1, length_ = 1, A_ = 1, force_unit_ = 1, steady_theta_ = 0, origin_ = 0;
    double gain_ = 1, steady_push_ = 0, steady_command_ = 0;
    double began_ = 0;  ///< s, the present piece
    double low_ = infinity, high_ = -infinity, rest_ = 0;
    long ticks_ = 0;
};

bool TickedProgram::Lane::finished()
{
    *job_.verdict = inquiry_.verdict();
    *job_.answered = true;
    return false;
}

bool TickedProgram::Lane::start(TickedJoint& joint, TickedPiece& first)
{
    if (!inquiry_.open()) return finished();
    const auto& friction = job_.joint->friction;
    const auto& law = *one_state(friction).law;
    auto& loop = inquiry_.loop();
    frame_ = loop.frame(), length_ = law.L[0], A_ = law.A, force_unit_ = friction.normal_load * law.A;
    steady_theta_ = steady_state(friction, frame_)[0];
    origin_ = inquiry_.origin();
    steady_command_ = loop.steady_command();
    const Push steady = push_of(actuator_, steady_command_, actuator_.supply_voltage, frame_);
    steady_push_ = steady.push;
    gain_ = steady_command_ != 0 ? steady.push / steady_command_ : actuator_.effort_gain;
    joint.M = job_.joint->mechanism.inertia * frame_ * frame_ / (length_ * force_unit_);
    joint.beta = law.B[0] / law.A;
    joint.lag = actuator_.lag > 0 ? actuator_.lag * frame_ / length_ : 1;
    open_tick(first);
    return true;
}

/// Of a command behind dead time and lag, per unit of force; the drag of the drive is apart.
double TickedProgram::Lane::effort_in_excess(double command) const
{
    const Push push = push_of(actuator_, command, actuator_.supply_voltage, frame_);
    return (push.push - steady_push_) / force_unit_;
}

void TickedProgram::Lane::open_tick(TickedPiece& piece)
{
    auto& loop = inquiry_.loop();
    began_ = loop.time();
    fill(loop.open_tick(), piece);
}

void TickedProgram::Lane::fill(double length, TickedPiece& piece)
{
    const auto& motion = inquiry_.loop().motion;
    const auto& joint = motion.joint;
    piece.y[0] = (motion.y[0] - origin_) / length_;
    piece.y[1] = motion.y[1];
    piece.y[2] = (motion.y[joint.first_state(0)] - steady_theta_) / A_;
    if (joint.has_lag()) {
        auto y = motion.y;
        piece.y[3] = effort_in_excess(joint.lagged(y.data()));
    }
    piece.force = effort_in_excess(joint.arriving);
    piece.drag = push_of(actuator_, joint.arriving, actuator_.supply_voltage, frame_).drag * frame_ / force_unit_;
    piece.length = length * frame_ / length_;
    const double rtol = job_.question->rtol;
    piece.rtol = inquiry_.coarse() ? std::max(rtol, rough) : rtol;
}

bool TickedProgram::Lane::arrive(const double* y, const TickedPassage& passed, TickedPiece& next)
{
    auto& loop = inquiry_.loop();
    auto& motion = loop.motion;
    const auto& joint = motion.joint;
    motion.y[0] = origin_ + length_ * y[0];
    motion.y[1] = y[1];
    motion.y[joint.first_state(0)] = steady_theta_ + A_ * y[2];
    if (joint.has_lag()) joint.lagged(motion.y.data()) = steady_command_ + y[3] * force_unit_ / gain_;
    take(passed);
    const double length = loop.next_piece();
    if (length > 0) {
        began_ = loop.time() + loop.period() - length;
        fill(length, next);
        return true;
    }
    auto& follower = inquiry_.follower();
    if (follower.uneven() || ++ticks_ % told_every == 0) tell();
    if (const auto end = follower.after_tick(true)) {
        inquiry_.ended(*end);
        low_ = infinity, high_ = -infinity, rest_ = 0, ticks_ = 0;
        if (!inquiry_.open()) return finished();
    }
    open_tick(next);
    return true;
}

void TickedProgram::Lane::take(const TickedPassage& passed)
{
    low_ = std::min(low_, passed.w_low), high_ = std::max(high_, passed.w_high);
    rest_ += passed.rest;
}

/// Hands the watch all that was passed: positions turn at V_0, and any place of the way serves where velocities do.
void TickedProgram::Lane::tell()
{
    auto& watch = inquiry_.follower().watch;
    const double place = inquiry_.loop().motion.y[0];
    if (low_ <= high_) watch.visit(frame_ * std::exp(low_), place), watch.visit(frame_ * std::exp(high_), place);
    watch.rest(rest_ * length_ / frame_);
    low_ = infinity, high_ = -infinity, rest_ = 0;
}

void TickedProgram::Lane::event(const TickedStep& s, const TickedPassage& before)
{
    take(before);
    const DenseOutput X{s.X0, s.X1, {s.X_dense[0], s.X_dense[1], s.X_dense[2]}};
    const DenseOutput w{s.w0, s.w1, {s.w_dense[0], s.w_dense[1], s.w_dense[2]}};
    if (const auto at = hermite_turning(w.y0, w.y1, w.slope_at_start(), w.slope_at_end(), 1)) {
        low_ = std::min(low_, w(*at)), high_ = std::max(high_, w(*at));
    }
    const bool slow0 = s.w0 <= near_rest_logarithm, slow1 = s.w1 <= near_rest_logarithm;
    if (slow0 && slow1) {
        rest_ += s.h;
    } else if (slow0 != slow1) {
        const double part = crossing(w, near_rest_logarithm);
        rest_ += s.h * (slow0 ? part : 1 - part);
    }
    if ((s.w0 > 0) == (s.w1 > 0)) return;
    const double part = crossing(w, 0), position = origin_ + length_ * X(part);
    inquiry_.loop().motion.y[0] = position;  // where the turn ends, for what tell() visits
    tell();
    inquiry_.follower().watch.pass(began_ + (s.t + part * s.h) * length_ / frame_, position, s.w1 < s.w0);
}

TickedProgram::TickedProgram() = default;
TickedProgram::~TickedProgram() = default;

bool TickedProgram::begin(const TickedJob& job, TickedJoint& joint, TickedPiece& first)
{
    lane_ = std::make_unique<Lane>(job);
    return lane_->start(joint, first);
}

bool TickedProgram::arrive(const double* y, const TickedPassage& passed, TickedPiece& next)
{
    return lane_->arrive(y, passed, next);
}

void TickedProgram::event(const TickedStep& step, const TickedPassage& before)
{
    lane_->event(step, before);
}

}  // namespace stickslip::lanes
