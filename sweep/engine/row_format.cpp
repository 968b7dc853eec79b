#include "sweep/engine/row_format.h"

#include <cstring>

namespace stickslip {

RowFormat::RowFormat(bool nonlinear)
{
    for (const Column& column : columns()) {
        if (column.nonlinear && !nonlinear) continue;
        (column.number ? numbers_ : codes_).push_back(&column);
    }
}

void RowFormat::pack(std::span<const PointResult> rows, std::byte* block) const
{
    for (const Column* column : numbers_) {
        auto* out = reinterpret_cast<double*>(block);
        const auto member = column->number;
        for (const PointResult& row : rows) *out++ = row.*member;
        block = reinterpret_cast<std::byte*>(out);
    }
    for (const Column* column : codes_) {
        const auto code = column->code;
        for (const PointResult& row : rows) *block++ = static_cast<std::byte>(code(row));
    }
}

void RowFormat::unpack(const std::byte* block, std::span<PointResult> rows) const
{
    for (const Column* column : numbers_)
        for (PointResult& row : rows) {
            std::memcpy(&(row.*column->number), block, sizeof(double));
            block += sizeof(double);
        }
    for (const Column* column : codes_)
        for (PointResult& row : rows) column->set_code(row, static_cast<std::uint8_t>(*block++));
}

std::string RowFormat::description() const
{
    std::string text;
    for (const auto* list : {&numbers_, &codes_})
        for (const Column* column : *list) text.append(column->name).append(":").append(column->meanings).append("\n");
    return text;
}

}  // namespace stickslip
