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

#include <cmath>

namespace stickslip::drawing {
namespace {

// The box as it is seen: wider than deep, deeper than high; from the front, somewhat from the right and from above.
constexpr double box_width = 1.35, box_depth = 1.15, box_height = 0.85;
constexpr double view_from[] = {0.62, -1.25, 0.72};
constexpr double view_angle = 22;  // degrees
constexpr double view_distance = 4.35;

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

}  // namespace

struct Scene::Stage {
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkMatrix4x4> projection;
};

Scene::Scene(const HeightField& field, const Rectangle& window) : window_(window), stage_(std::make_unique<Stage>())
{
    const auto surface = mesh(field);
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
    stage_->renderer->AddActor(actor);

    vtkNew<vtkContourFilter> contours;
    contours->SetInputData(surface);
    for (std::size_t i = 0; i < field.levels.size(); ++i) contours->SetValue(static_cast<int>(i), field.levels[i]);
    vtkNew<vtkPolyDataMapper> lines;
    lines->SetInputConnection(contours->GetOutputPort());
    lines->ScalarVisibilityOff();
    lines->SetResolveCoincidentTopologyToPolygonOffset();
    lines->SetRelativeCoincidentTopologyLineOffsetParameters(0, -60);
    vtkNew<vtkActor> contour_actor;
    contour_actor->SetMapper(lines);
    contour_actor->GetProperty()->SetColor(0.05, 0.05, 0.05);
    contour_actor->GetProperty()->SetLineWidth(2);
    contour_actor->GetProperty()->LightingOff();
    stage_->renderer->AddActor(contour_actor);

    auto* camera = stage_->renderer->GetActiveCamera();
    const double centre[] = {box_width / 2, box_depth / 2, box_height / 2};
    const double length = std::hypot(view_from[0], view_from[1], view_from[2]);
    camera->SetFocalPoint(centre);
    camera->SetPosition(centre[0] + view_distance * view_from[0] / length,
                        centre[1] + view_distance * view_from[1] / length,
                        centre[2] + view_distance * view_from[2] / length);
    camera->SetViewUp(0, 0, 1);
    camera->SetViewAngle(view_angle);
    camera->SetClippingRange(0.5 * view_distance, 2 * view_distance);
    stage_->projection->DeepCopy(camera->GetCompositeProjectionTransformMatrix(window.width / window.height, -1, 1));
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
