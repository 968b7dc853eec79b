#include "analysis/diagnosis/ladder/flexible.h"

#include "analysis/diagnosis/ladder/signal_functions.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr std::array<double, 3> ridges{1e-5, 1e-3, 1e-1};  // numerical: of a column's own square

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Sums over rows: functions with functions, functions with residual, residual with itself.
struct Gram {
    Matrix ff;
    Vector fr;
    double rr = 0, rows = 0;

    void add(const Matrix& functions, const Vector& residual)
    {
        if (ff.size() == 0) ff = Matrix::Zero(functions.cols(), functions.cols()), fr = Vector::Zero(functions.cols());
        ff.noalias() += functions.transpose() * functions;
        fr.noalias() += functions.transpose() * residual;
        rr += residual.squaredNorm(), rows += static_cast<double>(residual.size());
    }
};

/// One signal of one fold: what is seen, and the windows that are not.
struct Task {
    Gram seen;
    std::vector<Gram> held;
};

Vector solve(const Gram& g, const std::vector<Eigen::Index>& columns, double ridge)
{
    Matrix a = g.ff(columns, columns);
    const double least = 1e-12 * std::max(1e-300, a.diagonal().maxCoeff());
    a.diagonal() = a.diagonal() * (1 + ridge) + Vector::Constant(a.rows(), least);
    return a.ldlt().solve(Vector(g.fr(columns)));
}

double beyond(double square, double rows)
{
    return std::max(0.0, square - rows);
}

/// Squares beyond the noise that are left in all held-out windows.
double left_by(const std::vector<Task>& tasks, const std::vector<Eigen::Index>& columns)
{
    double best = infinity;
    for (const double ridge : ridges) {
        double sum = 0;
        for (const auto& task : tasks) {
            if (columns.empty() || task.seen.ff.size() == 0) {
                for (const auto& g : task.held) sum += beyond(g.rr, g.rows);
                continue;
            }
            const Vector c = solve(task.seen, columns, ridge);
            for (const auto& g : task.held)
                sum +=
                    beyond(g.rr - 2 * c.dot(Vector(g.fr(columns))) + c.dot(Matrix(g.ff(columns, columns)) * c), g.rows);
        }
        best = std::min(best, sum);
    }
    return best;
}

std::vector<Eigen::Index> columns_of(const std::vector<std::string_view>& kinds, std::string_view kind)
{
    std::vector<Eigen::Index> columns;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kind.empty() || kinds[i] == kind) columns.push_back(static_cast<Eigen::Index>(i));
    return columns;
}

/// The sums of one fold: functions of the signals as the model of this fold sees them.
void gather(const HeldOutData& data, const FunctionsOfSignals& functions, std::size_t fold, const Candidate& candidate,
            const std::vector<double>& si, Task& motion, Task& drive)
{
    for (const auto& c : data.cases()) {
        const auto s = functions.signals(c, candidate, si);
        const Matrix of_motion = functions.of_motion(s),
                     of_drive = c.effort_sigma > 0 ? functions.of_drive(s) : Matrix();
        std::vector<Window> held;
        for (const auto& w : data.windows(fold))
            if (w.record == c.number) held.push_back(w);
        Eigen::Index at = 0;
        const auto part = [&](Eigen::Index to, bool seen) {
            if (to <= at) return;
            const auto add = [&](Task& task, const Matrix& f, const Vector& r) {
                Gram& g = seen ? task.seen : task.held.emplace_back();
                g.add(f.middleRows(at, to - at), r.segment(at, to - at));
            };
            add(motion, of_motion, s.position);
            if (of_drive.rows() > 0) add(drive, of_drive, s.effort);
            at = to;
        };
        for (const auto& w : held) {
            part(static_cast<Eigen::Index>(w.from), true);
            part(static_cast<Eigen::Index>(w.to), false);
        }
        part(s.position.size(), true);
    }
}

}  // namespace

double Flexible::share_of(std::string_view signal) const
{
    for (const auto& [name, taken] : alone)
        if (name == signal) return taken;
    return 0;
}

Flexible regress(const HeldOutData& data, const Scales& scales, const Candidate& candidate,
                 const std::array<Eigen::VectorXd, HeldOutData::folds>& x, const Eigen::VectorXd& x_of_all)
{
    const FunctionsOfSignals functions(data.cases(), scales, candidate, in_si(candidate, x_of_all, scales));
    std::vector<Task> motion(HeldOutData::folds), drive(HeldOutData::folds);
    for (std::size_t f = 0; f < HeldOutData::folds; ++f)
        gather(data, functions, f, candidate, in_si(candidate, x[f], scales), motion[f], drive[f]);
    Flexible result;
    const double before_motion = left_by(motion, {}), before_drive = left_by(drive, {});
    result.before = before_motion + before_drive;
    double motion_left = std::min(before_motion, left_by(motion, columns_of(functions.kinds_of_motion(), "")));
    double drive_left = std::min(before_drive, left_by(drive, columns_of(functions.kinds_of_drive(), "")));
    for (const std::string_view kind :
         {"position", "direction", "velocity", "history", "acceleration", "effort", "time"}) {
        // all together may fit what they have seen too well: what one kind alone takes of the rest is explainable, too
        const double of_motion = left_by(motion, columns_of(functions.kinds_of_motion(), kind));
        motion_left = std::min(motion_left, of_motion);
        double taken = before_motion - of_motion;
        if (kind == "effort") {
            const double of_drive = left_by(drive, columns_of(functions.kinds_of_drive(), kind));
            drive_left = std::min(drive_left, of_drive);
            taken += before_drive - of_drive;
        }
        result.alone.emplace_back(kind, result.before > 0 ? std::max(0.0, taken) / result.before : 0);
    }
    result.after = motion_left + drive_left;
    std::stable_sort(result.alone.begin(), result.alone.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    return result;
}

}  // namespace stickslip::gap
