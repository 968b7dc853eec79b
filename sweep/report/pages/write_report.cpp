#include "sweep/report/pages/write_report.h"

#include "render/marked_page.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/report/pages/write_linked_report.h"

#include <tbb/task_group.h>

namespace stickslip {
std::filesystem::path write_report(const Report& report, const std::filesystem::path& directory)
{
    return write_linked_report(report, directory, {});
}

std::filesystem::path write_linked_report(const Report& report, const std::filesystem::path& directory,
                                          const TableMarks& marks, const PageAbove& above)
{
    const auto charts = directory / "charts";
    std::filesystem::create_directories(charts);
    std::size_t count = 0;
    for (const auto& section : report.sections) count += section.figures.size();
    std::vector<RenderedFigure> figures(count);  // of fixed size: the tasks below hold references into it
    tbb::task_group files;
    std::size_t i = 0;
    // Drawing takes turns; pixels and files of a drawn picture are made while the next one is drawn.
    for (const auto& section : report.sections)
        for (const auto& figure : section.figures) {
            figures[i] = render(figure);
            files.run([&charts, &rendered = figures[i], &id = figure.id] {
                if (!rendered.svg.empty()) write_whole(charts / (id + ".png"), png(rendered));
                if (!rendered.svg.empty()) write_whole(charts / (id + ".svg"), rendered.svg);
                if (!rendered.csv.empty()) write_whole(charts / (id + ".csv"), rendered.csv);
            });
            ++i;
        }
    files.wait();
    const auto file = directory / "report.html";
    write_whole(file, marked_page(report, figures, marks, above));
    return file;
}

std::filesystem::path write_sweep_report(const Report& report, const Spec& spec, const std::filesystem::path& directory)
{
    const auto page = write_report(report, directory);
    write_whole(directory / "joint.toml", joint_text(design_joint(spec)));
    return page;
}

}  // namespace stickslip
