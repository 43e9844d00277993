#include "meshes/near_lobes.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"

namespace meshes {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// With so many flips for every triangle that the edges do not grow so long that they pierce a near lobe.
Mesh irregular(const Mesh& mesh, std::uint64_t seed, double flips = 0.125) {
    return flipped(mesh, static_cast<std::size_t>(flips * static_cast<double>(mesh.triangles.size())), seed);
}

} // namespace

Mesh two_sheets(int cells, double gap) {
    const auto sheet = [cells](double height) {
        return grid(cells, cells, [height](double u, double v) {
            return glm::dvec3(u, v, height + 0.02 * std::sin(3 * turn * u) * std::cos(2 * turn * v));
        });
    };
    return joined(irregular(sheet(0), 1), irregular(sheet(gap), 2));
}

Mesh spiral(int along, int across, double gap) {
    constexpr double turns = 3;
    const auto place = [gap](double u, double v) {
        const double angle = turns * turn * u, radius = 0.3 + gap * turns * u;
        return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), 0.5 * v);
    };
    return irregular(grid(along, across, place), 3, 0.5);
}

Mesh thin_shell(int around, int along, double gap) {
    const auto place = [gap](double u, double v) { // v runs up the outside and down the inside
        const double height = 1.6 * (v < 0.5 ? 2 * v - 0.5 : 1.5 - 2 * v);
        const double radius = std::sqrt(1 - 0.5 * height * height) - (v < 0.5 ? 0 : gap);
        return glm::dvec3(radius * std::cos(turn * u), radius * std::sin(turn * u), height);
    };
    return irregular(grid(around, along, place, Ends::closed, Ends::closed), 4);
}

Mesh nested_spheres(int cells, double gap) {
    const Mesh inner = mapped(sphere(cells), [gap](glm::dvec3 p) { return (1 - gap) * p; });
    return joined(irregular(sphere(cells), 5), irregular(inner, 6));
}

Mesh self_passing_tube(int around, int across, double gap) {
    constexpr double lift = 0.15;
    const double radius = lift - gap / 2;
    const auto place = [radius](double u, double v) {
        const double t = turn * u;
        const glm::dvec3 middle(std::sin(t), 0.5 * std::sin(2 * t), lift * std::cos(t));
        const glm::dvec3 along = glm::normalize(glm::dvec3(std::cos(t), std::cos(2 * t), -lift * std::sin(t)));
        const glm::dvec3 side = glm::normalize(glm::cross(along, glm::dvec3(0, 0, 1))), up = glm::cross(side, along);
        return middle + radius * (std::cos(turn * v) * side + std::sin(turn * v) * up);
    };
    return irregular(grid(around, across, place, Ends::closed, Ends::closed), 7);
}

std::vector<Exhibit> near_lobes() {
    return {
        {"two sheets", two_sheets(32, 0.005), false},
        {"spiral", spiral(120, 12, 0.01), false},
        {"thin shell", thin_shell(96, 64, 0.02), true},
        {"nested spheres", nested_spheres(16, 0.02), true},
        {"self-passing tube", self_passing_tube(120, 24, 0.004), true},
    };
}

} // namespace meshes
