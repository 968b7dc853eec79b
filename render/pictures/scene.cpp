#include "render/pictures/scene.h"

#include "render/drawing/colour_map.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace stickslip::drawing {
namespace {

// The box as it is seen: wider than deep, deeper than high; from the front, somewhat from the right and from above.
constexpr double box_width = 1.35, box_depth = 1.15, box_height = 0.85;
constexpr double view_from[] = {0.62, -1.25, 0.72};
constexpr double view_distance = 4.35;
constexpr double margin = 1.01;  // keeps the box's smoothed edges inside the window

// Mostly its own colour, so that the colour bar can be trusted; a little light for the shape.
constexpr double ambient = 0.74, diffuse = 0.34;

vtkNew<vtkPolyData> mesh(const HeightField& field)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> heights;
    const std::size_t columns = field.columns.size(), rows = field.rows.size();
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i) {
            const double h = field.heights[j * columns + i], z = std::isfinite(h) ? h : 0;
            points->InsertNextPoint(box_width * field.columns[i], box_depth * field.rows[j], box_height * z);
            heights->InsertNextValue(z);
        }
    vtkNew<vtkCellArray> cells;
    for (std::size_t j = 0; j + 1 < rows; ++j)
        for (std::size_t i = 0; i + 1 < columns; ++i) {
            const std::size_t lower = j * columns + i, upper = lower + columns;
            std::vector<vtkIdType> corners;  // those that have a value: four, or three at the rim of a hole
            for (const std::size_t corner : {lower, lower + 1, upper + 1, upper})
                if (std::isfinite(field.heights[corner])) corners.push_back(static_cast<vtkIdType>(corner));
            if (corners.size() >= 3) cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
        }
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    surface->SetPolys(cells);
    surface->GetPointData()->SetScalars(heights);
    return surface;
}

vtkNew<vtkLookupTable> viridis()
{
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(256);
    table->SetRange(0, 1);
    for (int i = 0; i < 256; ++i) {
        const Colour c = from_hex(viridis_table[static_cast<std::size_t>(i)]);
        table->SetTableValue(i, c.red / 255.0, c.green / 255.0, c.blue / 255.0);
    }
    return table;
}

/// Exact at the ends, so that a hole beside a marked column does not swallow it.
double between(double share, double a, double b)
{
    return share == 0 ? a : share == 1 ? b : a + share * (b - a);
}

/// Lines over the surface where one coordinate is held, interpolated between the grid's own lines.
class Threads {
  public:
    void hold_column(const HeightField& field, double position)
    {
        const auto [low, share] = place(field.columns, position);
        const std::size_t high = std::min(low + 1, field.columns.size() - 1);
        for (std::size_t j = 0; j < field.rows.size(); ++j) {
            const double* row = field.heights.data() + j * field.columns.size();
            add(position, field.rows[j], between(share, row[low], row[high]));
        }
        end();
    }
    void hold_row(const HeightField& field, double position)
    {
        const auto [low, share] = place(field.rows, position);
        const std::size_t columns = field.columns.size(), high = std::min(low + 1, field.rows.size() - 1);
        for (std::size_t i = 0; i < columns; ++i)
            add(field.columns[i], position,
                between(share, field.heights[low * columns + i], field.heights[high * columns + i]));
        end();
    }
    vtkNew<vtkPolyData> lines() const
    {
        vtkNew<vtkPolyData> data;
        data->SetPoints(points_);
        data->SetLines(cells_);
        return data;
    }

  private:
    static std::pair<std::size_t, double> place(const std::vector<double>& list, double position)
    {
        const auto above = std::upper_bound(list.begin(), list.end(), position);
        if (above == list.begin() || list.size() < 2) return {0, 0};
        const auto low = std::min(static_cast<std::size_t>(above - list.begin()) - 1, list.size() - 2);
        return {low, std::clamp((position - list[low]) / (list[low + 1] - list[low]), 0.0, 1.0)};
    }
    void add(double x, double y, double z)
    {
        if (!std::isfinite(z)) return end();
        piece_.push_back(points_->InsertNextPoint(box_width * x, box_depth * y, box_height * z));
    }
    void end()
    {
        if (piece_.size() > 1) cells_->InsertNextCell(static_cast<vtkIdType>(piece_.size()), piece_.data());
        piece_.clear();
    }

    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> cells_;
    std::vector<vtkIdType> piece_;
};

}  // namespace

struct Scene::Stage {
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkMatrix4x4> projection;

    void add_surface(vtkPolyData* surface)
    {
        vtkNew<vtkPolyDataNormals> normals;
        normals->SetInputData(surface);
        normals->SplittingOff();
        const auto table = viridis();
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputConnection(normals->GetOutputPort());
        mapper->SetLookupTable(table);
        mapper->UseLookupTableScalarRangeOn();
        mapper->InterpolateScalarsBeforeMappingOn();
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        actor->GetProperty()->SetAmbient(ambient);
        actor->GetProperty()->SetDiffuse(diffuse);
        renderer->AddActor(actor);
    }

    void add_lines(vtkPolyData* lines, double grey, double width)
    {
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(lines);
        mapper->ScalarVisibilityOff();
        mapper->SetResolveCoincidentTopologyToPolygonOffset();
        mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -60);
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        actor->GetProperty()->SetColor(grey, grey, grey);
        actor->GetProperty()->SetLineWidth(static_cast<float>(width));
        actor->GetProperty()->LightingOff();
        renderer->AddActor(actor);
    }

    /// Looks at the box so that it just fills the window; returns the window's width over its height.
    double aim()
    {
        auto* camera = renderer->GetActiveCamera();
        const double centre[] = {box_width / 2, box_depth / 2, box_height / 2};
        const double length = std::hypot(view_from[0], view_from[1], view_from[2]);
        camera->SetFocalPoint(centre);
        camera->SetPosition(centre[0] + view_distance * view_from[0] / length,
                            centre[1] + view_distance * view_from[1] / length,
                            centre[2] + view_distance * view_from[2] / length);
        camera->SetViewUp(0, 0, 1);
        camera->SetClippingRange(0.4 * view_distance, 2 * view_distance);
        camera->SetViewAngle(90);  // tan 45° = 1: what is seen now are slopes of lines of sight
        auto* slopes = camera->GetCompositeProjectionTransformMatrix(1, -1, 1);
        double low[] = {1, 1}, high[] = {-1, -1};
        for (int corner = 0; corner < 8; ++corner) {
            const double world[] = {box_width * (corner & 1), box_depth * (corner >> 1 & 1), box_height * (corner >> 2),
                                    1};
            double seen[4];
            slopes->MultiplyPoint(world, seen);
            for (int k = 0; k < 2; ++k) {
                low[k] = std::min(low[k], seen[k] / seen[3]);
                high[k] = std::max(high[k], seen[k] / seen[3]);
            }
        }
        const double half_width = (high[0] - low[0]) / 2 * margin, half_height = (high[1] - low[1]) / 2 * margin;
        camera->SetViewAngle(2 * std::atan(half_height) * 180 / M_PI);
        camera->SetWindowCenter((low[0] + high[0]) / 2 / half_width, (low[1] + high[1]) / 2 / half_height);
        const double aspect = half_width / half_height;
        projection->DeepCopy(camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1));
        return aspect;
    }
};

Scene::Scene(const HeightField& field, double left, double top, double width) : stage_(std::make_unique<Stage>())
{
    const auto surface = mesh(field);
    stage_->add_surface(surface);
    Threads threads;
    for (const double position : field.columns_marked) threads.hold_column(field, position);
    for (const double position : field.rows_marked) threads.hold_row(field, position);
    stage_->add_lines(threads.lines(), 0.85, 1.2);
    vtkNew<vtkContourFilter> contours;
    contours->SetInputData(surface);
    for (std::size_t i = 0; i < field.levels.size(); ++i) contours->SetValue(static_cast<int>(i), field.levels[i]);
    contours->Update();
    stage_->add_lines(contours->GetOutput(), 0.05, 2);
    // Whole pixels: the photograph and the projection must agree on the aspect.
    window_ = {left, top, width, std::round(width / stage_->aim())};
}

Scene::~Scene() = default;

Point Scene::project(double x, double y, double z) const
{
    const double world[] = {box_width * x, box_depth * y, box_height * z, 1};
    double seen[4];
    stage_->projection->MultiplyPoint(world, seen);
    return {window_.left + window_.width * (0.5 + 0.5 * seen[0] / seen[3]),
            window_.top + window_.height * (0.5 - 0.5 * seen[1] / seen[3])};
}

Snapshot Scene::photograph(int fineness) const
{
    return drawing::photograph(stage_->renderer, static_cast<int>(window_.width) * fineness,
                               static_cast<int>(window_.height) * fineness);
}

}  // namespace stickslip::drawing
