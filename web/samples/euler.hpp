#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

/// The compressible Euler equations for a gamma-law gas that carries passive mass fractions:
///
///     d(rho)/dt   + div(rho u)         = 0        mass
///     d(rho u)/dt + div(rho u u + p I) = 0        momentum
///     dE/dt       + div((E + p) u)     = 0        energy, E = p / (gamma - 1) + rho |u|^2 / 2
///     d(rho Y)/dt + div(rho Y u)       = 0        partial mass of each traced material
///
/// Solved by the second-order MUSCL-Hancock finite-volume scheme with the monotonized central limiter and the HLLC
/// flux, one axis at a time in Strang's order (Toro, "Riemann Solvers and Numerical Methods for Fluid Dynamics",
/// chapters 10, 14, 16). Single precision. The result does not depend on the number of threads.
namespace euler {

inline constexpr int tracers = 2;
inline constexpr int variables = 5 + tracers;

/// The state of a cell as people state it. Any consistent set of units.
struct Primitive {
    float density = 1;
    std::array<float, 3> velocity{};
    float pressure = 1;
    std::array<float, tracers> fraction{}; ///< mass fraction of each traced material, 0...1
};

/// What lies beyond the faces of the box.
enum class Boundary {
    outflow,  ///< the last cell goes on for ever: waves leave
    wall,     ///< a mirror: nothing gets through
    periodic, ///< the opposite face
};

struct Grid {
    std::array<int, 3> cells{};     ///< along x, y and z
    std::array<double, 3> origin{}; ///< the lowest corner of the box
    double spacing = 1;             ///< edge of a cell, which is a cube

    std::size_t size() const { return std::size_t(cells[0]) * cells[1] * cells[2]; }
};

/// Sums over all cells times the volume of a cell.
struct Totals {
    double mass = 0, energy = 0;
    std::array<double, tracers> partial_mass{};
};

class Flow {
public:
    /// The state at a point. A cell starts with the mean of the conserved quantities at 4 x 4 x 4 points in it.
    using InitialState = std::function<Primitive(double x, double y, double z)>;

    Flow(const Grid& grid, double gamma, Boundary boundary, const InitialState& state, int threads);

    /// Advances to the time `end`, in steps as long as the Courant number allows. Returns the number of steps.
    int advance(double end);

    /// The state of cell (i, j, k), whose place in the memory is i + nx (j + ny k).
    Primitive at(std::size_t cell) const;

    Totals totals() const;
    const Grid& grid() const { return grid_; }
    double gamma() const { return gamma_; }

private:
    void fill(std::size_t cell, const std::array<int, 3>& index, const InitialState& state);
    void step(double dt, const std::array<int, 3>& axes);
    void sweep(int axis, float dt_over_spacing);
    double fastest_wave() const;

    Grid grid_;
    double gamma_;
    Boundary boundary_;
    int threads_;
    /// Conserved quantities a unit of volume: mass, three momenta, energy, partial masses. x runs fastest.
    std::array<std::vector<float>, variables> conserved_;
};

} // namespace euler
