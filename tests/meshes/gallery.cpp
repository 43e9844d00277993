#include "meshes/gallery.hpp"

#include <utility>

#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "meshes/voxel_surface.hpp"

namespace meshes {
namespace {

enum class Precision { single, twice };

Exhibit exhibit(std::string name, Mesh mesh, bool closed, Precision precision = Precision::twice) {
    add_usual_fields(mesh);
    return {std::move(name), precision == Precision::single ? in_single(mesh) : std::move(mesh), closed};
}

Mesh moved(const Mesh& mesh, glm::dvec3 by) {
    return mapped(mesh, [by](glm::dvec3 p) { return p + by; });
}

Mesh shrunk(const Mesh& mesh, double by) {
    return mapped(mesh, [by](glm::dvec3 p) { return by * p; });
}

} // namespace

std::vector<Exhibit> gallery() {
    const Mesh rough_plane = jittered(flipped(plane(24, 20), 2000, 1), 0.01, 2);
    const Mesh bowl = cut(sphere(11), [](glm::dvec3 p) { return p.z < 0.4; });
    const Mesh pair = joined(sphere(7), moved(torus(20, 12), {3, 0, 0}));
    return {
        exhibit("sphere", sphere(11), true, Precision::single),
        exhibit("irregular sphere", shuffled(flipped(sphere(11), 3000, 3), 4), true),
        exhibit("noisy sphere", noisy_sphere(10, 0.04, 5), true),
        exhibit("cube", flipped(cube(9), 1000, 6), true, Precision::single),
        exhibit("torus", torus(36, 18), true),
        exhibit("two-holed plate", shrunk(pierced_plate(2, 3), 0.1), true, Precision::single),
        exhibit("smooth three-holed plate", smoothed(shrunk(pierced_plate(3, 3), 0.1), 3), true),
        exhibit("sphere and torus", pair, true),
        exhibit("rough plane", rough_plane, false, Precision::single),
        exhibit("bowl", bowl, false),
        exhibit("cylinder", shuffled(cylinder(40, 16), 7), false),
        exhibit("twisted band", twisted_band(60, 8), false, Precision::single),
        exhibit("pleats", pleats(5, 6), false),
        exhibit("terrain", terrain(5, 8), false, Precision::single),
    };
}

} // namespace meshes
