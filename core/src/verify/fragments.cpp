#include "verify/fragments.hpp"

#include <algorithm>
#include <cmath>

namespace meshbound::verification {
namespace {

/// A triangle whose longest edge is more than this many times its height is cut.
constexpr double slender = 8;
/// Halvings of one triangle, at most: 64 fragments.
constexpr int most_halvings = 6;
/// Where there are few triangles, so many fragments more than these do no harm.
constexpr std::size_t always_affordable = 131'072;

double squared_length(const JointSurface& surface, const Fragment& fragment, int corner) {
    double sum = 0;
    for (int k = 0; k < surface.dimensions; ++k) {
        const double along = fragment.at(surface, (corner + 1) % 3, k) - fragment.at(surface, corner, k);
        sum += along * along;
    }
    return sum;
}

struct Shape {
    int longest = 0; ///< the corner that the longest edge begins at
    bool is_slender = false;
};

Shape shape_of(const JointSurface& surface, const Fragment& fragment) {
    std::array<double, 3> squares{};
    for (int i = 0; i < 3; ++i) squares[i] = squared_length(surface, fragment, i);
    const auto longest = static_cast<int>(std::max_element(squares.begin(), squares.end()) - squares.begin());
    const double whole = squares[longest], next = squares[(longest + 1) % 3], last = squares[(longest + 2) % 3];
    // By the law of cosines: twice the dot product of the two edges that leave the longest edge's end.
    const double dot = (whole + next - last) / 2;
    const double squared_area = std::max(0.0, whole * next - dot * dot); // of the parallelogram
    return {longest, whole * whole > slender * slender * squared_area};
}

/// Halves a fragment at its longest edge, again and again, until its parts are slender no more.
void cut(const JointSurface& surface, const Fragment& fragment, int halvings, std::vector<Fragment>& fragments) {
    const Shape shape = halvings > 0 ? shape_of(surface, fragment) : Shape{};
    if (!shape.is_slender) {
        fragments.push_back(fragment);
        return;
    }
    const int from = shape.longest, to = (from + 1) % 3;
    std::array<float, 2> middle{};
    for (std::size_t i = 0; i < 2; ++i) middle[i] = (fragment.corners[from][i] + fragment.corners[to][i]) / 2;
    Fragment first = fragment, second = fragment;
    first.corners[to] = second.corners[from] = middle;
    cut(surface, first, halvings - 1, fragments);
    cut(surface, second, halvings - 1, fragments);
}

} // namespace

std::vector<Fragment> cut_into_fragments(const JointSurface& surface) {
    std::vector<Fragment> fragments;
    std::vector<std::uint32_t> to_be_cut;
    fragments.reserve(surface.triangles.size());
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        if (shape_of(surface, {t}).is_slender) to_be_cut.push_back(t);
        else fragments.push_back({t});
    }
    if (to_be_cut.empty()) return fragments;
    const std::size_t spare = std::max(surface.triangles.size(), always_affordable) / to_be_cut.size();
    int halvings = 0;
    while (halvings < most_halvings && (std::size_t{2} << halvings) <= spare) ++halvings;
    for (const std::uint32_t t : to_be_cut) cut(surface, {t}, halvings, fragments);
    return fragments;
}

} // namespace meshbound::verification
