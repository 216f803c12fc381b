#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "slope/couple/simulation.hpp"

namespace slope::tools::test {

/// The slope of the paper's Fig. 5 (36 m x 12 m, 7 m high, 1:1.8) on a lattice of 0.25 m with a water table at
/// y = 3 m, and a made-up failure: along a circle through the toe, what is above it has slid by `slide` (m), and
/// water has entered from the surface to a depth of about `wet_depth` (m).
[[nodiscard]] couple::ParticleTable synthetic_slope(double time, double slide = 0.0, double wet_depth = 0.0);

/// A column 0.08 m x 1 m on a lattice of 0.02 m whose suction head is `top_head` (m) times (y / 1 m)^1.5.
[[nodiscard]] couple::ParticleTable synthetic_column(double time, double top_head);

/// The particles as slope-render gets them: written to a file and read back.
[[nodiscard]] vtkSmartPointer<vtkPolyData> as_polydata(const couple::ParticleTable& table);

}  // namespace slope::tools::test
