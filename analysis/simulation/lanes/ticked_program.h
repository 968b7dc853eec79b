// What one lane of sampled loops is doing: it moves a joint over one piece of a tick after another, and asks the loop's
// own controller in between. Scalar code, compiled once for every processor, while the kernels that integrate are
// compiled for each: a kernel includes this and nothing of the loop.
#pragma once
#include <cstddef>
#include <memory>

namespace stickslip {
struct Joint;
struct LoopQuestion;
struct LoopVerdict;
}  // namespace stickslip

namespace stickslip::lanes {

/// A joint that lanes can follow (ticked_batch.h), the question, and where the answer goes. `answered` stays false
/// where the motion could not be followed in lanes.
struct TickedJob {
    const Joint* joint;
    const LoopQuestion* question;
    LoopVerdict* verdict;
    bool* answered;
};

/// The joint of a lane: groups of ticked_model.h.
struct TickedJoint {
    double M = 1, beta = 1, lag = 1;
};

/// From here, under this force, for so long, to this tolerance; all in the units of the groups.
struct TickedPiece {
    double y[4] = {0, 0, 0, 0};
    double force = 0, drag = 0;
    double length = 1;
    double rtol = 1e-8;
};

/// What the motion passed since the program last looked.
struct TickedPassage {
    double w_low, w_high, rest;
};

/// A step with an event: its start in the piece, its length, values and dense output (rodas5p_table.h) of X and w.
struct TickedStep {
    double t, h;
    double X0, X1, X_dense[3];
    double w0, w1, w_dense[3];
};

class TickedProgram {
  public:
    TickedProgram();
    ~TickedProgram();
    TickedProgram(const TickedProgram&) = delete;
    TickedProgram& operator=(const TickedProgram&) = delete;

    /// False where the answer takes no motion.
    bool begin(const TickedJob& job, TickedJoint& joint, TickedPiece& first);
    /// The piece has ended here; false where the job is done.
    bool arrive(const double* y, const TickedPassage& passed, TickedPiece& next);
    /// V passed V_0 or near rest, or turned.
    void event(const TickedStep& step, const TickedPassage& before);

  private:
    class Lane;
    std::unique_ptr<Lane> lane_;
};

}  // namespace stickslip::lanes
