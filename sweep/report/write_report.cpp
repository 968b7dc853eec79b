#include "sweep/report/write_report.h"

#include "render/marked_page.h"
#include "sweep/files/json/drawn_charts.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/report/write_linked_report.h"

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
    std::map<std::string, std::string> drawn;    // and its elements stay where they are, too
    std::vector<std::string> same;
    const DrawnCharts before(charts);
    tbb::task_group files;
    std::size_t i = 0;
    // Drawing takes turns; pixels and files of a drawn picture are made while the next one is drawn.
    for (const auto& section : report.sections)
        for (const auto& figure : section.figures) {
            auto& rendered = figures[i++];
            const auto key = figure_key(figure);
            if (auto kept = before.kept(figure.id, key)) {
                rendered = std::move(*kept);
                same.push_back(figure.id);
                continue;
            }
            rendered = render(figure);
            if (!rendered.missing.empty()) {  // what is missing may be there next time
                if (!rendered.csv.empty()) write_whole(charts / (figure.id + ".csv"), rendered.csv);
                continue;
            }
            files.run([&before, &rendered, &id = figure.id, &said = drawn[figure.id], key] {
                said = before.write(id, key, rendered);
            });
        }
    files.wait();
    if (count > 0) before.write_index(drawn, same);
    const auto file = directory / "report.html";
    write_whole(file, marked_page(report, figures, marks, above));
    return file;
}

std::filesystem::path write_sweep_report(const Report& report, const Spec& spec, const std::string& text,
                                         const std::filesystem::path& directory)
{
    const auto page = write_report(report, directory);
    if (spec.joint.pose.of) write_whole(directory / "spec.toml", text);
    write_whole(directory / "joint.toml", joint_text(design_joint(spec)));
    return page;
}

}  // namespace stickslip
