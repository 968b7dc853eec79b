// What a real loop answers to forces on the link, and where its roots go with the gain: the same questions as loop.h
// and forced_response.h ask of the ideal loop.
#pragma once
#include <complex>
#include <optional>
#include <vector>

#include "analysis/loop/opened_loop.h"
#include "analysis/stability/forced_response.h"
#include "analysis/stability/loop_margins.h"
#include "analysis/stability/real_loop.h"

namespace stickslip {

/// A joint about steady sliding under its own loop, ideal or real, with a force on the link as its input, or what is
/// added to its commands.
class LoopResponse {
  public:
    enum class Input { force, command };
    /// By either theory. Nothing without steady sliding and where real_loop has none; with forces as the input neither
    /// for sampled loops around delayed friction, as between ticks there is no map of it.
    static std::optional<LoopResponse> of(const Joint& joint, Theory theory, Input input = Input::force);

    /// X/D(iω) of the link. Ideal: (19). Continuous: (iω − A − b c e^{−iωτ})⁻¹ d. Sampled, whose readings see no more,
    /// the motion at the samples: (e^{iωT} − M)⁻¹ (e^{iωT} − e^{AT})(iω − A)⁻¹ d.
    std::complex<double> at(double omega) const;
    /// Of what is added to the command where the controller leaves it: the motion of the link per command, and
    /// 1/(1 + L), what remains of the command. Real loops only.
    struct ByCommand {
        std::complex<double> motion, remains;
    };
    ByCommand by_command(double omega) const;
    /// By a scan of `points` frequencies around the roots, up to half the sampling rate; NaN for an unstable loop.
    ResponsePeak peak(int points = 400) const;
    /// The force is held over each of its steps, of a sampled loop over each tick that begins within the step: exact
    /// there. Dead time of a continuous loop is carried by Chebyshev nodes, whose error is far below what is drawn.
    ForcedResponse forced(const SampledForce& force) const;

    /// Of a sampled loop ln(z)/T; where roots have no end, the rightmost.
    const std::vector<std::complex<double>>& roots() const { return roots_; }
    /// max Re s of the loop, which may be further right than the roots that were found.
    double growth() const { return growth_; }
    /// Whether each frequency sums over aliases, which takes a hundred times as long.
    bool sums_aliases() const { return sums_aliases_; }
    /// Time between samples; 0 of a continuous loop.
    double period() const { return period_; }

  private:
    LoopResponse() = default;
    void read_at_command();
    /// Everything the closed loop holds, per input of its own system.
    Eigen::VectorXcd closed(double omega, const Eigen::VectorXcd& input) const;
    Eigen::Index size() const;
    ForcedResponse ticks(const SampledForce& force) const;
    ForcedResponse continuous(const SampledForce& force) const;

    LinearJoint linear_;
    std::optional<RealLoop> loop_;  ///< nothing: the ideal one
    LoopPlant plant_;
    Eigen::VectorXd pushed_;  ///< rates per force on the link, of the plant
    int speed_ = 0;
    double period_ = 0, growth_ = missing;
    bool sums_aliases_ = false;
    std::optional<OpenedLoop> opened_, carried_;  ///< of a delayed loop, to its command and link
    std::optional<Resolvent> closed_;             ///< of any other, from its command to link and command
    std::vector<std::complex<double>> roots_;     ///< of a sampled loop ln(z)/T
};

/// Roots of any loop over k_p, row by row; column i follows one root. Those of a sampled loop are ln(z)/T. Empty where
/// the loop has no k_p of its own to turn.
std::vector<std::vector<std::complex<double>>> root_locus(const Joint& joint, const std::vector<double>& gains);

}  // namespace stickslip
