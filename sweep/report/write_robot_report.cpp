#include "sweep/report/write_robot_report.h"

#include "render/marked_page.h"
#include "sweep/files/text/whole_file.h"

namespace stickslip {

std::filesystem::path write_robot_report(const RobotPage& page, const std::filesystem::path& directory)
{
    const auto file = directory / "robot.html";
    write_whole(file, marked_page(page.report, {}, page.marks));
    return file;
}

}  // namespace stickslip
