#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/bounds.hpp"
#include "meshbound/mesh.hpp"
#include "metric/multipliers.hpp"

namespace meshbound {

/// The components of one variable within a row, side by side.
struct RowGroup {
    int first = 0, count = 0;   ///< components [first, first + count) of the row
    std::uint32_t variable = 0; ///< 0 is position, i + 1 the mesh's variable i
    bool bounded = true;        ///< a free variable stands in units of its scale and holds nothing back
    bool finite = true;         ///< whether all of it are numbers; else it is free, and NaN stands where it is none
};

/// Every vertex as one row of numbers measured in bounds: position first, then the variables, each component centred
/// and divided by its variable's bound. Every check of the guarantee becomes "norm of each group ≤ 1", without units.
/// Free variables are divided by their extent instead. Vertices that no triangle uses have zeros.
///
/// For the inner loops (BoundedRows) the bounded variables come first, in pairs of columns: variables with several
/// components, each from an even column on, then the scalars; but the first scalars fill the odd columns that those
/// leave. Free variables come last. Unused columns are zero.
///
///     position (3), velocity (3), p, q, T, free: e:   | x y | z p | vx vy | vz q | T 0 | e 0 |   (each centred)
class Rows {
public:
    Rows() = default;
    /// `bound_multiplier`: the mesh's variable that multiplies the bounds; null: none does (see Options::bound_multiplier).
    /// `inputs`: by row the vertex of the mesh (see Surface::inputs); empty: all are themselves.
    Rows(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const Variable* bound_multiplier = nullptr,
         const std::vector<std::uint32_t>& inputs = {});

    const double* operator[](std::uint32_t vertex) const { return &values_[vertex * std::size_t(width_)]; }
    /// Numbers in a row, zeros between groups among them; even.
    int width() const { return width_; }
    const std::vector<RowGroup>& groups() const { return groups_; } ///< by variable: position, then the mesh's

    /// Position of a vertex, in bounds of position.
    glm::dvec3 position(std::uint32_t vertex) const {
        const double* row = (*this)[vertex];
        return {row[0], row[1], row[2]};
    }

    /// The unit of a group: multiply a difference of its row components by this to have it in the variable's unit.
    double unit(const RowGroup& group) const { return units_[group.variable]; }

    /// The largest ratio that may be accepted: 1 less what rounding can hide.
    double limit() const { return limit_; }

    /// What multiplies the bounds at a vertex, and on the way between two.
    const Multipliers& multipliers() const { return multipliers_; }

private:
    void append_group(RowGroup& group);
    void arrange_groups();

    int width_ = 0;
    double limit_ = 1;
    Multipliers multipliers_;
    std::vector<RowGroup> groups_;
    std::vector<double> units_;
    std::vector<double> values_;
};

/// Largest ratio to its bound over the bounded groups of a row of differences, squared.
double squared_ratio(const double* difference, const std::vector<RowGroup>& groups);

} // namespace meshbound
