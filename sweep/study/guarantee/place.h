// Where a joint and its records stand among those of a population: what a promise about the population asks of them.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "analysis/joint/joint.h"
#include "analysis/results/point.h"

#include <string>
#include <vector>

namespace stickslip::guarantee {

/// What joint and records are, as far as it decides how well causes can be distinguished. NaN: not stated.
struct Place {
    std::string kind;                  ///< "revolute single-mass, effort, pid, coulomb-viscous"
    std::vector<std::string> columns;  ///< in every record
    bool noise_documented = false;
    double records = 0;
    double duration = 0;         ///< s, of all records together
    double period = missing;     ///< s, of the loop
    double step = missing;       ///< s, median between two rows
    double noise = missing;      ///< documented noise and step of the encoder, of the travel
    double bandwidth = missing;  ///< rad/s, √(k_p / inertia)
};

/// `columns`: the names of those that every record has.
Place place_of(const Joint& joint, const std::vector<Record>& records, std::vector<std::string> columns);

/// Why a joint does not belong to a population.
struct Stranger {
    enum class Why { joint, kind, columns, noise, range };
    Why why = Why::range;
    std::string number{};                 ///< range: "duration"
    double value = 0, low = 0, high = 0;  ///< of that number
    std::string given{}, known{};         ///< of the others: what the joint has, and what the population has
};

/// What keeps a place out of the population of others: it has to be of a kind that is among them, with the columns and
/// the documents of one of that kind, and its numbers have to lie between theirs, or up to a quarter beyond.
std::vector<Stranger> strangers(const Place& place, const std::vector<Place>& population);

}  // namespace stickslip::guarantee
