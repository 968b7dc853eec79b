// What the command of a record consists of: a regression on changes of the documented controller's terms. Internal to
// analysis/diagnosis/audit.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

#include <array>
#include <vector>

namespace stickslip::gap {

/// A change of one term; the dead zone is no linear one and is searched.
enum Term { k_p_term, k_v_term, k_i_term, coulomb_term, acceleration_term, velocity_term, linear_terms };

/// What is left of the command after the documented controller, and what one unit of each change would add: a factor
/// on documented terms, the coefficient itself of others.
struct CommandTerms {
    struct Row {
        double left = 0, command = 0;
        std::array<double, linear_terms> change{};
        std::size_t record = 0;
        std::size_t stretch = 0;  ///< of all records: behind a hole nobody knows what the integral holds
    };
    std::vector<Row> rows;
    double square = 0;  ///< of the command, summed
    std::array<bool, linear_terms> factor{}, possible{};
    bool integrates = false;  ///< the document does; what the integral began a stretch with is open then
};

/// With this dead zone in place of the documented one.
CommandTerms command_terms(const std::vector<Case>& cases, double dead_zone, double limit);

/// Means of so many successive rows of a record. A sum of rows is as linear in the terms as a row is, and what was not
/// logged between rows averages out of it.
CommandTerms averaged(const CommandTerms& terms, std::size_t rows);

/// The rows of one record.
CommandTerms of_record(const CommandTerms& terms, std::size_t record);

struct TermFit {
    std::array<double, linear_terms> value{}, error{};
    double misfit = infinity;  ///< rms of what is left over that of the command
};

/// Least squares over the chosen changes.
TermFit fit_terms(const CommandTerms& terms, const std::vector<int>& chosen);

}  // namespace stickslip::gap
