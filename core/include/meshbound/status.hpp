#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "meshbound/api.hpp"

namespace meshbound {

/// What can be wrong with the input of a call. One value a fault, so that a caller can act on it.
enum class Fault {
    none,
    no_triangles,        ///< the mesh has no triangle with three distinct vertices
    bad_coordinates,     ///< the number of coordinates is not a multiple of three
    bad_index,           ///< a triangle names a vertex that does not exist
    non_finite_position, ///< NaN or infinity among the coordinates of vertices that triangles use, or as their distance
    bad_components,      ///< a variable has no or too many components
    wrong_value_count,   ///< a variable has fewer or more values than the vertices need
    non_finite_value,    ///< the same of a variable with a bound; without a bound it is carried along as it is
    empty_name,          ///< a variable without a name
    duplicate_name,      ///< two variables with one name, or a variable named "position" or "*"
    unknown_variable,    ///< a bound for a variable that the mesh has not
    bad_bound,           ///< a bound that is negative, zero or not a finite number
    bound_too_fine,      ///< a bound below what double precision can carry beside the magnitude of the values
    bad_option,          ///< an option outside its documented range
    bad_checkpoint,      ///< a checkpoint that contradicts itself, or has spent what a bound allows
    bad_map,             ///< a map that is not one between the surfaces it came with
    bad_levels,          ///< a list of levels of detail that is empty or does not go from fine to coarse
    too_large,           ///< more vertices or triangles than 32-bit indices can name, or more than 65 535 variables
    out_of_memory,       ///< the machine (or WebAssembly's 4 GB) has no room for this reduction
};

/// The name of a fault as written above: "bad_index". Stable, meant for programs.
MESHBOUND_API std::string_view fault_name(Fault fault);

/// The outcome of a call: fine, or a fault with a sentence that says what is wrong and where.
struct [[nodiscard]] Status {
    Fault fault = Fault::none;
    std::string message;  ///< for people: "Triangle 7 names vertex 12, but the mesh has 10 vertices (0 to 9)."
    std::string variable; ///< the variable at fault; empty where none is
    std::optional<std::size_t> index; ///< the triangle, vertex or value at fault, where one is

    bool ok() const { return fault == Fault::none; }
};

} // namespace meshbound
