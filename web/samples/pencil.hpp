#pragma once

#include <array>
#include <vector>

#include "euler.hpp"

namespace euler {

/// Cells beyond each end of a row that a second-order step needs.
inline constexpr int ghosts = 2;

/// Pressure / (gamma - 1) below this fraction of the kinetic energy is lost in rounding; it is lifted to it.
inline constexpr float smallest_pressure_to_kinetic = 1e-5F;

/// One row of cells along one axis, with room for everything that a one-dimensional step computes on the way. Variable
/// 1 is the velocity (or momentum) along the row, 2 and 3 the others.
class Pencil {
public:
    explicit Pencil(int cells);

    /// The conserved quantities of cell i of the row, 0 <= i < cells, before and after `step`.
    float* conserved(int variable) { return conserved_[variable].data() + ghosts; }

    /// One step of MUSCL-Hancock with HLLC fluxes.
    void step(float dt_over_spacing, float gamma, Boundary boundary);

private:
    using Rows = std::array<std::vector<float>, variables>;

    void fill_ghosts(Boundary boundary);
    void find_primitives(float gamma);
    void find_faces(float dt_over_spacing, float gamma);
    void find_fluxes(float gamma);
    void update(float dt_over_spacing);

    int cells_;
    Rows conserved_, primitive_; ///< with ghosts
    Rows low_, high_;            ///< primitive states at the faces of a cell after half a step, with ghosts
    Rows flux_;                  ///< flux_[i] goes from cell i - 1 to cell i
};

} // namespace euler
