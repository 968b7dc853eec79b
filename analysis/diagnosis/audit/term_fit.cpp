// Least squares over changes of the controller's terms.
#include "analysis/diagnosis/audit/command_terms.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Rows less the mean of those that begin with an integral of their own, as if each had a constant beside the terms.
struct AboutMeans {
    std::vector<CommandTerms::Row> rows;
    double square = 0;  ///< of the command, about its means, too
    std::size_t means = 0;
};

AboutMeans about_means(const std::vector<CommandTerms::Row>& rows, std::size_t CommandTerms::Row::*group)
{
    AboutMeans about{rows};
    for (std::size_t from = 0, to = 0; from < rows.size(); from = to, ++about.means) {
        CommandTerms::Row mean;
        for (to = from; to < rows.size() && rows[to].*group == rows[from].*group; ++to) {
            mean.left += rows[to].left, mean.command += rows[to].command;
            for (std::size_t i = 0; i < linear_terms; ++i) mean.change[i] += rows[to].change[i];
        }
        const double part = 1 / static_cast<double>(to - from);
        for (std::size_t k = from; k < to; ++k) {
            about.rows[k].left -= part * mean.left, about.rows[k].command -= part * mean.command;
            for (std::size_t i = 0; i < linear_terms; ++i) about.rows[k].change[i] -= part * mean.change[i];
            about.square += about.rows[k].command * about.rows[k].command;
        }
    }
    return about;
}

/// An integral that the file lacks is no better for each hole that it could begin anew behind.
AboutMeans with_open_integral(const CommandTerms& terms)
{
    const bool holes = std::ranges::adjacent_find(terms.rows, [](const auto& a, const auto& b) {
                           return a.record == b.record && a.stretch != b.stretch;
                       }) != terms.rows.end();
    if (terms.integrates && holes) return about_means(terms.rows, &CommandTerms::Row::stretch);
    auto about = about_means(terms.rows, &CommandTerms::Row::record);
    about.square = terms.square;
    return about;
}

}  // namespace

TermFit fit_terms(const CommandTerms& terms, const std::vector<int>& chosen)
{
    const bool open = terms.integrates || std::find(chosen.begin(), chosen.end(), k_i_term) != chosen.end();
    const auto n = static_cast<Eigen::Index>(chosen.size());
    TermFit fit;
    if (terms.rows.empty() || !(terms.square > 0)) return fit;
    const AboutMeans about = open ? with_open_integral(terms) : AboutMeans{};
    const auto& rows = open ? about.rows : terms.rows;
    const double square = open ? about.square : terms.square;
    if (!(square > 0)) return fit;
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(n), x = Eigen::VectorXd::Zero(n), whole = x, column(n);
    const auto column_of = [&](const CommandTerms::Row& row) {
        for (Eigen::Index i = 0; i < n; ++i) column[i] = row.change[chosen[static_cast<std::size_t>(i)]];
    };
    for (std::size_t k = 0; k < rows.size(); ++k) {
        column_of(terms.rows[k]);
        whole += column.cwiseAbs2();
        column_of(rows[k]);
        G += column * column.transpose();
        g += rows[k].left * column;
    }
    const Eigen::VectorXd unit = G.diagonal().cwiseSqrt();
    if (n > 0 && !(unit.minCoeff() > 0)) return fit;
    const Eigen::MatrixXd scaled = unit.cwiseInverse().asDiagonal() * G * unit.cwiseInverse().asDiagonal();
    const Eigen::LDLT<Eigen::MatrixXd> solver(scaled);
    constexpr double collinear = 1e-10;  // numerical: of the pivots, those with the constants included
    if (n > 0) {
        const double of_constants = G.diagonal().cwiseQuotient(whole).minCoeff();
        if (!(solver.vectorD().minCoeff() > collinear && of_constants > collinear)) return fit;
        x = solver.solve(g.cwiseQuotient(unit)).cwiseQuotient(unit);
    }
    double squares = 0;
    for (const auto& row : rows) {
        column_of(row);
        const double left = row.left - (n > 0 ? column.dot(x) : 0.0);
        squares += left * left;
    }
    fit.misfit = std::sqrt(squares / square);
    const double free = static_cast<double>(rows.size()) - static_cast<double>(about.means) - static_cast<double>(n);
    const double variance = squares / std::max(1.0, free);
    if (n == 0) return fit;
    const Eigen::MatrixXd inverse = solver.solve(Eigen::MatrixXd::Identity(n, n));
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto term = static_cast<std::size_t>(chosen[static_cast<std::size_t>(i)]);
        fit.value[term] = x[i];
        fit.error[term] = std::sqrt(variance * inverse(i, i)) / unit[i];
    }
    return fit;
}

}  // namespace stickslip::gap
