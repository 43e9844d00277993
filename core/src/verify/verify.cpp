#include "verify/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "verify/joint_surface.hpp"
#include "verify/joint_tree.hpp"
#include "verify/sampling.hpp"

namespace meshbound::verification {
namespace {

/// A ratio below this is no deviation; so surfaces that coincide are not searched for the rounding between them.
constexpr double negligible = 1e-6;

class Search {
public:
    Search(const JointSurface& from, const JointSurface& to, const JointSpace& space)
        : from_(from), to_(to), space_(space), tree_(to, space), metric_(space.components),
          point_(static_cast<std::size_t>(space.dimensions())), foot_point_(point_.size()) {}

    Deviation farthest(std::size_t samples) {
        sample_surface(from_, samples, [this](const Sample& sample) { look_at(sample); });
        return worst_;
    }

private:
    /// A sample matters only if it is farther than the worst so far: the search ends with the first point within that.
    void look_at(const Sample& sample) {
        ++worst_.samples;
        place(from_, sample.triangle, sample.barycentric, point_);
        const double limit = multiplier_at(sample);
        const double enough = limit * std::max(worst_.ratio, negligible);
        const Foot foot = tree_.nearest(point_.data(), enough, last_);
        last_ = foot.triangle;
        if (foot.nearest.distance <= enough) return;
        worst_.ratio = foot.nearest.distance / limit;
        worst_.triangle = sample.triangle;
        worst_.barycentric = sample.barycentric;
        const auto [distance, u, v] = foot.nearest;
        place(to_, foot.triangle, {1 - u - v, u, v}, foot_point_);
        std::size_t dominant = 0;
        metric_.between(point_.data(), foot_point_.data(), &dominant);
        worst_.variable = space_.variables[dominant];
    }

    double multiplier_at(const Sample& sample) const {
        if (from_.multipliers.empty()) return 1;
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += sample.barycentric[i] * from_.multipliers[from_.triangles[sample.triangle][i]];
        return sum;
    }

    static void place(const JointSurface& surface, std::uint32_t triangle, const std::array<double, 3>& barycentric,
                      std::vector<double>& point) {
        const auto& [a, b, c] = surface.triangles[triangle];
        for (std::size_t k = 0; k < point.size(); ++k)
            point[k] = barycentric[0] * surface.row(a)[k] + barycentric[1] * surface.row(b)[k] +
                       barycentric[2] * surface.row(c)[k];
    }

    const JointSurface &from_, &to_;
    const JointSpace& space_;
    JointTree tree_;
    JointDistance metric_;
    std::vector<double> point_, foot_point_;
    Deviation worst_;
    std::uint32_t last_ = 0; ///< neighbouring samples mostly end on the same triangle
};

Deviation farthest(const Mesh& mesh, const JointSurface& from, const JointSurface& to,
                   const JointSpace& space, std::size_t samples) {
    if (space.dimensions() == 0) return {}; // everything is free
    Deviation deviation = Search(from, to, space).farthest(samples);
    const auto& triangle = from.triangles[deviation.triangle];
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 3; ++i)
            deviation.position[c] += deviation.barycentric[i] * value_at(mesh.position, triangle[i], c);
    return deviation;
}

const std::vector<double>& checked(const std::vector<double>& multipliers, const Mesh& original) {
    if (!multipliers.empty() && multipliers.size() != vertex_count(original))
        throw std::invalid_argument("one multiplier a vertex of the original");
    for (const double multiplier : multipliers)
        if (!(multiplier > 0 && std::isfinite(multiplier)))
            throw std::invalid_argument("a multiplier must be positive");
    return multipliers;
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

Judgement judge(const Mesh& original, const Mesh& reduced, const std::vector<double>& bounds,
                std::size_t samples, const std::vector<double>& multipliers) {
    const JointSpace space = joint_space(original, bounds);
    JointSurface one = joint_surface(original, space);
    const JointSurface other = joint_surface(reduced, space);
    one.multipliers = checked(multipliers, original);
    return {farthest(original, one, other, space, samples), farthest(reduced, other, one, space, samples)};
}

Judgement judge_boundary(const Mesh& original, const Mesh& reduced,
                         const std::vector<double>& bounds, std::size_t samples,
                         const std::vector<double>& multipliers) {
    const JointSpace space = joint_space(original, bounds);
    JointSurface one = joint_boundary(original, space);
    const JointSurface other = joint_boundary(reduced, space);
    one.multipliers = checked(multipliers, original);
    Judgement judgement;
    if (one.triangles.empty() && other.triangles.empty()) return judgement;
    if (one.triangles.empty() || other.triangles.empty()) {
        judgement.from_original.ratio = std::numeric_limits<double>::infinity();
        return judgement;
    }
    return {farthest(original, one, other, space, samples), farthest(reduced, other, one, space, samples)};
}

} // namespace meshbound::verification
