// How rows travel: column by column, the numbers first, so that a journalled chunk can be copied into results.nc as it
// is.
#pragma once
#include "analysis/results/point.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace stickslip {

/// The columns of a sweep and their place in a packed block of rows.
class RowFormat {
  public:
    explicit RowFormat(bool nonlinear);

    /// Columns of doubles, then columns of single bytes, each in the order of columns().
    std::span<const Column* const> numbers() const { return numbers_; }
    std::span<const Column* const> codes() const { return codes_; }

    std::size_t bytes_per_point() const { return numbers_.size() * sizeof(double) + codes_.size(); }

    /// Byte offset of the i-th column of numbers / codes in a block of that many rows.
    std::size_t number_offset(std::size_t i, std::size_t rows) const { return i * rows * sizeof(double); }
    std::size_t code_offset(std::size_t i, std::size_t rows) const
    {
        return numbers_.size() * rows * sizeof(double) + i * rows;
    }

    /// Writes rows.size() * bytes_per_point() bytes; `block` must be aligned for doubles.
    void pack(std::span<const PointResult> rows, std::byte* block) const;

    /// The reverse of pack; members without a column keep their value.
    void unpack(const std::byte* block, std::span<PointResult> rows) const;

    /// Names and meanings of all columns: two programs with equal descriptions read each other's rows.
    std::string description() const;

  private:
    std::vector<const Column*> numbers_, codes_;
};

}  // namespace stickslip
