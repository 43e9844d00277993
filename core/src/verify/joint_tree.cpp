#include "verify/joint_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meshbound::verification {

namespace {
constexpr std::uint32_t leaf_size = 4;
}

JointTree::JointTree(const JointSurface& surface, const JointSpace& space)
    : surface_(surface), components_(space.components), metric_(space.components),
      fragments_(cut_into_fragments(surface)),
      origin_(static_cast<std::size_t>(surface.dimensions), 0.0), scaled_{origin_, origin_, origin_},
      looked_at_(surface.triangles.size(), 0) {
    nodes_.reserve(fragments_.size());
    nodes_.push_back({});
    split(0, 0, static_cast<std::uint32_t>(fragments_.size()));
}

void JointTree::enclose(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    const auto d = static_cast<std::size_t>(surface_.dimensions);
    boxes_.resize(nodes_.size() * 2 * d);
    if (!surface_.multipliers.empty()) {
        most_multipliers_.resize(nodes_.size());
        most_multipliers_[node] = most_multiplier(begin, end);
    }
    double* low = boxes_.data() + node * 2 * d;
    double* high = low + d;
    std::fill(low, high, std::numeric_limits<double>::infinity());
    std::fill(high, high + d, -std::numeric_limits<double>::infinity());
    for (std::uint32_t i = begin; i < end; ++i)
        for (int corner = 0; corner < 3; ++corner)
            for (std::size_t k = 0; k < d; ++k) {
                const double place = fragments_[i].at(surface_, corner, static_cast<int>(k));
                low[k] = std::min(low[k], place);
                high[k] = std::max(high[k], place);
            }
}

double JointTree::most_multiplier(std::uint32_t begin, std::uint32_t end) const {
    double most = 0;
    for (std::uint32_t i = begin; i < end; ++i)
        for (const std::uint32_t vertex : surface_.triangles[fragments_[i].triangle])
            most = std::max(most, surface_.multipliers[vertex]);
    return most;
}

int JointTree::widest(std::uint32_t node) const {
    const int d = surface_.dimensions;
    const double* low = boxes_.data() + std::size_t{node} * 2 * d;
    int best = 0;
    for (int k = 1; k < d; ++k)
        if (low[d + k] - low[k] > low[d + best] - low[best]) best = k;
    return best;
}

double JointTree::middle(const Fragment& fragment, int dimension) const {
    return fragment.at(surface_, 0, dimension) + fragment.at(surface_, 1, dimension) +
           fragment.at(surface_, 2, dimension);
}

void JointTree::split(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    enclose(node, begin, end);
    if (end - begin <= leaf_size) {
        nodes_[node] = {begin, end - begin};
        return;
    }
    const int dimension = widest(node);
    const std::uint32_t half = begin + (end - begin) / 2;
    std::nth_element(fragments_.begin() + begin, fragments_.begin() + half, fragments_.begin() + end,
                     [&](const Fragment& s, const Fragment& t) { return middle(s, dimension) < middle(t, dimension); });
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node] = {children, 0};
    nodes_.resize(nodes_.size() + 2);
    split(children, begin, half);
    split(children + 1, half, end);
}

/// No point in the box is nearer, its distance divided by its multiplier.
double JointTree::box_distance(const double* q, std::uint32_t node) const {
    const auto d = static_cast<std::size_t>(surface_.dimensions);
    const double* low = boxes_.data() + node * 2 * d;
    const double* high = low + d;
    double worst = 0;
    std::size_t k = 0;
    for (int n : components_) {
        double sum = 0;
        for (const std::size_t end = k + static_cast<std::size_t>(n); k < end; ++k) {
            const double out = std::max({low[k] - q[k], q[k] - high[k], 0.0});
            sum += out * out;
        }
        worst = std::max(worst, sum);
    }
    return std::sqrt(worst) / (most_multipliers_.empty() ? 1 : most_multipliers_[node]);
}

/// A point p of the triangle is the sum of w_i p_i, its multiplier m that of w_i m_i. So with v_i = w_i m_i / m, which are
/// barycentric coordinates as well, (p - q) / m is the sum of v_i (p_i - q) / m_i: a point of another triangle, the one with
/// these corners, and nearest where that comes nearest to the origin.
Nearest JointTree::multiplied(const double* q, std::uint32_t triangle, double enough, double cutoff) const {
    const auto& t = surface_.triangles[triangle];
    std::array<double, 3> multipliers{};
    for (std::size_t i = 0; i < 3; ++i) {
        multipliers[i] = surface_.multipliers[t[i]];
        for (std::size_t k = 0; k < origin_.size(); ++k)
            scaled_[i][k] = (surface_.row(t[i])[k] - q[k]) / multipliers[i];
    }
    Nearest found =
        metric_.to_triangle(origin_.data(), scaled_[0].data(), scaled_[1].data(), scaled_[2].data(), enough, cutoff);
    const double first = (1 - found.u - found.v) / multipliers[0];
    const double second = found.u / multipliers[1], third = found.v / multipliers[2];
    found.u = second / (first + second + third);
    found.v = third / (first + second + third);
    return found;
}

void JointTree::try_triangle(const double* q, double enough, std::uint32_t triangle, Foot& foot) const {
    if (looked_at_[triangle] == search_) return; // by another fragment of it
    looked_at_[triangle] = search_;
    ++distances_found_;
    const auto& t = surface_.triangles[triangle];
    const Nearest found = most_multipliers_.empty()
                              ? metric_.to_triangle(q, surface_.row(t[0]), surface_.row(t[1]), surface_.row(t[2]),
                                                    enough, foot.nearest.distance)
                              : multiplied(q, triangle, enough, foot.nearest.distance);
    if (found.distance < foot.nearest.distance) foot = {found, triangle};
}

Foot JointTree::nearest(const double* q, double enough, std::uint32_t guess) const {
    Foot foot;
    ++search_;
    try_triangle(q, enough, guess, foot);
    pending_.assign(1, {box_distance(q, 0), 0});
    while (!pending_.empty() && foot.nearest.distance > enough) {
        const Pending next = pending_.back();
        pending_.pop_back();
        if (next.distance >= foot.nearest.distance) continue;
        const Node& node = nodes_[next.node];
        for (std::uint32_t i = 0; i < node.count && foot.nearest.distance > enough; ++i)
            try_triangle(q, enough, fragments_[node.first + i].triangle, foot);
        if (node.count > 0) continue;
        Pending near{box_distance(q, node.first), node.first};
        Pending far{box_distance(q, node.first + 1), node.first + 1};
        if (far.distance < near.distance) std::swap(near, far);
        pending_.push_back(far);
        pending_.push_back(near);
    }
    return foot;
}

} // namespace meshbound::verification
