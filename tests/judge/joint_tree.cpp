#include "judge/joint_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace judge {

namespace {
constexpr std::uint32_t leaf_size = 4;
}

JointTree::JointTree(const JointSurface& surface_, const JointSpace& space)
    : surface(surface_), components(space.components), metric(space.components), order(surface.triangles.size()) {
    if (order.empty()) throw std::invalid_argument("a surface without triangles");
    std::iota(order.begin(), order.end(), 0U);
    nodes.reserve(order.size());
    nodes.push_back({});
    split(0, 0, static_cast<std::uint32_t>(order.size()));
}

void JointTree::enclose(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    const auto d = static_cast<std::size_t>(surface.dimensions);
    boxes.resize(nodes.size() * 2 * d);
    double* low = boxes.data() + node * 2 * d;
    double* high = low + d;
    std::fill(low, high, std::numeric_limits<double>::infinity());
    std::fill(high, high + d, -std::numeric_limits<double>::infinity());
    for (std::uint32_t i = begin; i < end; ++i)
        for (std::uint32_t vertex : surface.triangles[order[i]]) {
            const double* row = surface.row(vertex);
            for (std::size_t k = 0; k < d; ++k) {
                low[k] = std::min(low[k], row[k]);
                high[k] = std::max(high[k], row[k]);
            }
        }
}

int JointTree::widest(std::uint32_t node) const {
    const int d = surface.dimensions;
    const double* low = boxes.data() + std::size_t{node} * 2 * d;
    int best = 0;
    for (int k = 1; k < d; ++k)
        if (low[d + k] - low[k] > low[d + best] - low[best]) best = k;
    return best;
}

double JointTree::middle(std::uint32_t triangle, int dimension) const {
    const auto& t = surface.triangles[triangle];
    return surface.row(t[0])[dimension] + surface.row(t[1])[dimension] + surface.row(t[2])[dimension];
}

void JointTree::split(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    enclose(node, begin, end);
    if (end - begin <= leaf_size) {
        nodes[node] = {begin, end - begin};
        return;
    }
    const int dimension = widest(node);
    const std::uint32_t half = begin + (end - begin) / 2;
    std::nth_element(order.begin() + begin, order.begin() + half, order.begin() + end,
                     [&](std::uint32_t s, std::uint32_t t) { return middle(s, dimension) < middle(t, dimension); });
    const auto children = static_cast<std::uint32_t>(nodes.size());
    nodes[node] = {children, 0};
    nodes.resize(nodes.size() + 2);
    split(children, begin, half);
    split(children + 1, half, end);
}

double JointTree::box_distance(const double* q, std::uint32_t node) const {
    const auto d = static_cast<std::size_t>(surface.dimensions);
    const double* low = boxes.data() + node * 2 * d;
    const double* high = low + d;
    double worst = 0;
    std::size_t k = 0;
    for (int n : components) {
        double sum = 0;
        for (const std::size_t end = k + static_cast<std::size_t>(n); k < end; ++k) {
            const double out = std::max({low[k] - q[k], q[k] - high[k], 0.0});
            sum += out * out;
        }
        worst = std::max(worst, sum);
    }
    return std::sqrt(worst);
}

void JointTree::try_triangle(const double* q, double enough, std::uint32_t triangle, Foot& foot) const {
    const auto& t = surface.triangles[triangle];
    const Nearest found =
        metric.to_triangle(q, surface.row(t[0]), surface.row(t[1]), surface.row(t[2]), enough, foot.nearest.distance);
    if (found.distance < foot.nearest.distance) foot = {found, triangle};
}

Foot JointTree::nearest(const double* q, double enough, std::uint32_t guess) const {
    Foot foot;
    try_triangle(q, enough, guess, foot);
    pending.assign(1, {box_distance(q, 0), 0});
    while (!pending.empty() && foot.nearest.distance > enough) {
        const Pending next = pending.back();
        pending.pop_back();
        if (next.distance >= foot.nearest.distance) continue;
        const Node& node = nodes[next.node];
        for (std::uint32_t i = 0; i < node.count && foot.nearest.distance > enough; ++i)
            try_triangle(q, enough, order[node.first + i], foot);
        if (node.count > 0) continue;
        Pending near{box_distance(q, node.first), node.first};
        Pending far{box_distance(q, node.first + 1), node.first + 1};
        if (far.distance < near.distance) std::swap(near, far);
        pending.push_back(far);
        pending.push_back(near);
    }
    return foot;
}

} // namespace judge
