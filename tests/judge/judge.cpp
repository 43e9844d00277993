#include "judge/judge.hpp"

#include <algorithm>
#include <limits>

#include "judge/joint_surface.hpp"
#include "judge/joint_tree.hpp"
#include "judge/sampling.hpp"

namespace judge {
namespace {

/// A ratio below this is no deviation; so surfaces that coincide are not searched for the rounding between them.
constexpr double negligible = 1e-6;

class Search {
public:
    Search(const JointSurface& from_, const JointSurface& to, const JointSpace& space_)
        : from(from_), space(space_), tree(to, space), surface(to), metric(space.components),
          point(static_cast<std::size_t>(space.dimensions())), foot_point(point.size()) {}

    Deviation farthest(std::size_t samples) {
        sample_surface(from, samples, [this](const Sample& sample) { look_at(sample); });
        return worst;
    }

private:
    /// A sample matters only if it is farther than the worst so far: the search ends with the first point within that.
    void look_at(const Sample& sample) {
        ++worst.samples;
        place(from, sample.triangle, sample.barycentric, point);
        const double enough = std::max(worst.ratio, negligible);
        const Foot foot = tree.nearest(point.data(), enough, last);
        last = foot.triangle;
        if (foot.nearest.distance <= enough) return;
        worst.ratio = foot.nearest.distance;
        worst.triangle = sample.triangle;
        worst.barycentric = sample.barycentric;
        const auto [distance, u, v] = foot.nearest;
        place(surface, foot.triangle, {1 - u - v, u, v}, foot_point);
        std::size_t dominant = 0;
        metric.between(point.data(), foot_point.data(), &dominant);
        worst.variable = space.variables[dominant];
    }

    static void place(const JointSurface& of, std::uint32_t triangle, const std::array<double, 3>& barycentric,
                      std::vector<double>& point) {
        const auto& t = of.triangles[triangle];
        for (std::size_t k = 0; k < point.size(); ++k)
            point[k] =
                barycentric[0] * of.row(t[0])[k] + barycentric[1] * of.row(t[1])[k] + barycentric[2] * of.row(t[2])[k];
    }

    const JointSurface& from;
    const JointSpace& space;
    JointTree tree;
    const JointSurface& surface;
    JointDistance metric;
    std::vector<double> point, foot_point;
    Deviation worst;
    std::uint32_t last = 0; ///< neighbouring samples mostly end on the same triangle
};

Deviation farthest(const meshbound::Mesh& mesh, const JointSurface& from, const JointSurface& to,
                   const JointSpace& space, std::size_t samples) {
    if (space.dimensions() == 0) return {}; // everything is free
    Deviation deviation = Search(from, to, space).farthest(samples);
    const auto& triangle = from.triangles[deviation.triangle];
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 3; ++i)
            deviation.position[c] += deviation.barycentric[i] * value_at(mesh.position, triangle[i], c);
    return deviation;
}

} // namespace

double Judgement::ratio() const { return std::max(from_original.ratio, from_reduced.ratio); }

std::ostream& operator<<(std::ostream& out, const Judgement& judgement) {
    const auto print = [&out](const char* name, const Deviation& d) {
        out << name << ": " << d.ratio << " of the bound of variable " << d.variable << " (0 is position) in triangle "
            << d.triangle << " at (" << d.position[0] << ", " << d.position[1] << ", " << d.position[2] << "), "
            << d.samples << " samples";
    };
    print("from the original", judgement.from_original);
    print("; from the reduced", judgement.from_reduced);
    return out;
}

Judgement judge(const meshbound::Mesh& original, const meshbound::Mesh& reduced, const std::vector<double>& bounds,
                std::size_t samples) {
    const JointSpace space = joint_space(original, bounds);
    const JointSurface one = joint_surface(original, space);
    const JointSurface other = joint_surface(reduced, space);
    return {farthest(original, one, other, space, samples), farthest(reduced, other, one, space, samples)};
}

Judgement judge_boundary(const meshbound::Mesh& original, const meshbound::Mesh& reduced,
                         const std::vector<double>& bounds, std::size_t samples) {
    const JointSpace space = joint_space(original, bounds);
    const JointSurface one = joint_boundary(original, space);
    const JointSurface other = joint_boundary(reduced, space);
    Judgement judgement;
    if (one.triangles.empty() && other.triangles.empty()) return judgement;
    if (one.triangles.empty() || other.triangles.empty()) {
        judgement.from_original.ratio = std::numeric_limits<double>::infinity();
        return judgement;
    }
    return {farthest(original, one, other, space, samples), farthest(reduced, other, one, space, samples)};
}

} // namespace judge
