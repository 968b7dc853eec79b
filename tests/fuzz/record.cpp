// Any bytes as a record, plain or gzip: columns of equal length in ascending time, or a list of complaints.
#include "sweep/files/records/record_file.h"
#include "sweep/files/text/bad_input.h"
#include "tests/fuzz/input_file.h"

#include <cmath>

namespace {

void check(const stickslip::Record& record)
{
    using stickslip::Record;
    for (std::size_t k = 0; k < record.rows(); ++k) {
        fuzz::promise(std::isfinite(record.time[k]), "a time that is not finite");
        fuzz::promise(k == 0 || record.time[k] > record.time[k - 1], "time that does not ascend");
    }
    constexpr std::vector<double> Record::*columns[] = {
        &Record::reference_position, &Record::reference_velocity, &Record::position,      &Record::velocity,
        &Record::effort_command,     &Record::effort_measured,    &Record::drive,         &Record::current,
        &Record::supply_voltage,     &Record::temperature,        &Record::torque_enable, &Record::link_position,
        &Record::normal_load};
    for (const auto column : columns) {
        const auto& values = record.*column;
        fuzz::promise(values.empty() || values.size() == record.rows(), "columns of different length");
        for (const double value : values) fuzz::promise(!std::isinf(value), "an infinite value");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace stickslip;
    static const Joint joint;
    constexpr RecordLimits limits{.rows = 100'000};
    try {
        const fuzz::InputFile file({data, size});
        check(read_record(file.path(), joint, {}, limits).record);
    } catch (const BadInput& refusal) {
        fuzz::promise(!refusal.messages().empty(), "a refusal without a reason");
    }
    return 0;
}
