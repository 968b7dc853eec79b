// OpenGL without a screen, for the pictures that need it: an EGL context without any surface (Mesa's software renderer
// or a graphics card). Neither an X server nor DISPLAY is needed.
#pragma once
#include "render/drawing/encode.h"

#include <string>

class vtkRenderer;

namespace stickslip::drawing {

struct Snapshot {
    Raster raster;        ///< RGBA, transparent where the scene is empty
    std::string missing;  ///< why there is none; empty when there is one
};

/// Renders a scene with smoothed edges. Call it under the drawing lock.
Snapshot photograph(vtkRenderer* scene, int width, int height);

}  // namespace stickslip::drawing
