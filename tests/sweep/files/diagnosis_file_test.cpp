// diagnosis.json read back: what is none is refused in words of ours, never in a library's.
#include "sweep/files/json/diagnosis_file.h"

#include <catch2/catch.hpp>

#include "tests/sweep/files/messages.h"
#include "tests/temporary_directory.h"

#include <fstream>

using namespace stickslip;
using Catch::Matchers::EndsWith;

TEST_CASE("a file that is no diagnosis is refused with the place or the reason", "[check]")
{
    const TemporaryDirectory room;
    const auto file = room.path() / "diagnosis.json";
    const auto said = [&](const std::string& text) {
        std::ofstream(file, std::ios::trunc) << text;
        return messages_of([&] { read_diagnosis(file); }).at(0);
    };
    const std::string format = R"("format": "stickslip-diagnosis/2")";
    CHECK_THAT(
        said("{" + format),
        EndsWith("diagnosis.json: is not complete JSON; reading stopped at byte 35"));  // the first that is missing
    CHECK_THAT(said("{" + format + ", \"version\": 1e999}"),
               EndsWith("diagnosis.json: has a number beyond the largest that a double holds, 1.8e308"));
    CHECK_THAT(said("{" + format + ", \"verdict\": 7}"),
               EndsWith("lacks a field of diagnosis.json, or has it in another form; expected what "
                        "docs/schema/diagnosis.schema.json says"));
}
