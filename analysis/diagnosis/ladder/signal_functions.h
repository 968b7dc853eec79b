// Functions of a joint's own signals that a force may be made of.
#pragma once
#include "analysis/diagnosis/ladder/windows.h"

#include <functional>
#include <string_view>

namespace stickslip::gap {

/// One record, row by row, as a model's observer sees it.
struct Signals {
    std::size_t record = 0;
    double step = 1e-3;  ///< s from row to row
    std::vector<double> time, reading, velocity, drive, acceleration;
    Eigen::VectorXd position, effort;  ///< what the model leaves, in units of the documented noise
};

class FunctionsOfSignals {
  public:
    FunctionsOfSignals(const std::vector<Case>& cases, const Scales& scales, const Candidate& candidate,
                       const std::vector<double>& si);

    Signals signals(const Case& c, const Candidate& candidate, const std::vector<double>& si) const;
    /// One column a function, each as the observer's error would show it if it were a force.
    Eigen::MatrixXd of_motion(const Signals& s) const;
    /// Functions of the drive that a measured effort may differ by.
    Eigen::MatrixXd of_drive(const Signals& s) const;
    const std::vector<std::string_view>& kinds_of_motion() const { return motion_; }
    const std::vector<std::string_view>& kinds_of_drive() const { return drive_; }

  private:
    using Take = std::function<void(std::string_view kind, const std::vector<double>& force)>;
    void forces(const Signals& s, const Take& take) const;

    double low_ = 0, high_ = 1, speed_ = 1, effort_ = 1, duration_ = 1;
    std::size_t records_ = 1;
    std::vector<double> in_time_, in_position_;  ///< waves that stand out in what is left
    std::vector<std::string_view> motion_, drive_;
};

}  // namespace stickslip::gap
