#include "meshes/shapes.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include <glm/geometric.hpp>

#include "meshes/random.hpp"

namespace meshes {
namespace {

constexpr double turn = 2 * std::numbers::pi;

} // namespace

Mesh from_points(const std::vector<glm::dvec3>& points, std::vector<glm::uvec3> triangles) {
    std::vector<double> values;
    values.reserve(3 * points.size());
    for (const glm::dvec3& p : points) values.insert(values.end(), {p.x, p.y, p.z});
    Mesh mesh;
    mesh.position.values = std::move(values);
    mesh.triangles = std::move(triangles);
    return mesh;
}

glm::dvec3 point(const Mesh& mesh, std::size_t vertex) {
    return {value_at(mesh.position, vertex, 0), value_at(mesh.position, vertex, 1), value_at(mesh.position, vertex, 2)};
}

Mesh grid(int columns, int rows, const std::function<glm::dvec3(double, double)>& place, Ends across, Ends along) {
    const int across_count = columns + (across == Ends::open);
    const int along_count = rows + (along == Ends::open);
    std::vector<glm::dvec3> points;
    for (int j = 0; j < along_count; ++j)
        for (int i = 0; i < across_count; ++i) points.push_back(place(double(i) / columns, double(j) / rows));
    const auto vertex = [&](int i, int j) {
        return static_cast<std::uint32_t>((j % along_count) * across_count + i % across_count);
    };
    std::vector<glm::uvec3> triangles;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
            if ((i + j) % 2 == 0) {
                triangles.push_back({a, b, c});
                triangles.push_back({a, c, d});
            } else {
                triangles.push_back({a, b, d});
                triangles.push_back({b, c, d});
            }
        }
    return from_points(points, std::move(triangles));
}

Mesh plane(int columns, int rows, double width, double height) {
    return grid(columns, rows, [=](double u, double v) { return glm::dvec3(u * width, v * height, 0); });
}

Mesh cube(int cells) {
    std::map<std::tuple<int, int, int>, std::uint32_t> vertices;
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
    const auto vertex = [&](glm::ivec3 p) {
        const auto [entry, is_new] = vertices.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(points.size()));
        if (is_new) points.push_back(glm::dvec3(p) / double(cells));
        return entry->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side)
            for (int j = 0; j < cells; ++j)
                for (int i = 0; i < cells; ++i) {
                    const auto corner = [&](int di, int dj) {
                        glm::ivec3 p(0);
                        p[axis] = side * cells;
                        p[(axis + 1) % 3] = i + di;
                        p[(axis + 2) % 3] = j + dj;
                        return vertex(p);
                    };
                    const std::uint32_t a = corner(0, 0), b = corner(side, 1 - side), c = corner(1, 1),
                                        d = corner(1 - side, side);
                    triangles.push_back({a, b, c});
                    triangles.push_back({a, c, d});
                }
    return from_points(points, std::move(triangles));
}

Mesh sphere(int cells) { return noisy_sphere(cells, 0, 0); }

Mesh noisy_sphere(int cells, double noise, std::uint64_t seed) {
    Random random(seed);
    const Mesh box = cube(cells);
    std::vector<glm::dvec3> points;
    for (std::size_t v = 0; v < vertex_count(box); ++v)
        points.push_back((1 + noise * random.uniform(-1, 1)) * glm::normalize(point(box, v) - 0.5));
    return from_points(points, box.triangles);
}

Mesh torus(int around, int across, double tube) {
    const auto place = [tube](double u, double v) {
        const double radius = 1 + tube * std::cos(turn * v);
        return glm::dvec3(radius * std::cos(turn * u), radius * std::sin(turn * u), tube * std::sin(turn * v));
    };
    return grid(around, across, place, Ends::closed, Ends::closed);
}

Mesh cylinder(int around, int along) {
    const auto place = [](double u, double v) { return glm::dvec3(std::cos(turn * u), std::sin(turn * u), 2 * v); };
    return grid(around, along, place, Ends::closed, Ends::open);
}

Mesh pleats(int folds, int cells_a_fold) {
    const auto place = [folds](double u, double v) {
        const double phase = u * folds;
        const double height = std::abs(phase - 2 * std::floor(phase / 2) - 1);
        return glm::dvec3(phase * 0.5, 2 * v, height);
    };
    return grid(folds * cells_a_fold, 2 * cells_a_fold, place);
}

Mesh terrain(int power, std::uint64_t seed, double roughness) {
    const int cells = 1 << power;
    Random random(seed);
    std::vector<double> height(static_cast<std::size_t>(cells + 1) * (cells + 1), 0);
    const auto at = [&](int i, int j) -> double& { return height[static_cast<std::size_t>(j) * (cells + 1) + i]; };
    double size = 0.3;
    for (int step = cells; step > 1; step /= 2, size *= roughness) {
        const int half = step / 2;
        for (int j = half; j < cells; j += step)
            for (int i = half; i < cells; i += step)
                at(i, j) = (at(i - half, j - half) + at(i + half, j - half) + at(i - half, j + half) +
                            at(i + half, j + half)) /
                               4 +
                           size * random.uniform(-1, 1);
        for (int j = 0; j <= cells; j += half)
            for (int i = (j / half) % 2 == 0 ? half : 0; i <= cells; i += step) {
                double sum = 0, count = 0;
                for (const auto& [di, dj] : {std::pair{-half, 0}, {half, 0}, {0, -half}, {0, half}})
                    if (i + di >= 0 && i + di <= cells && j + dj >= 0 && j + dj <= cells) {
                        sum += at(i + di, j + dj);
                        ++count;
                    }
                at(i, j) = sum / count + size * random.uniform(-1, 1);
            }
    }
    return grid(cells, cells, [&](double u, double v) {
        return glm::dvec3(u, v, at(static_cast<int>(std::lround(u * cells)), static_cast<int>(std::lround(v * cells))));
    });
}

Mesh twisted_band(int around, int across) {
    const auto place = [](double u, double v) {
        const double width = 0.8 * (v - 0.5), angle = turn * u;
        const double radius = 1 + width * std::cos(angle);
        return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), width * std::sin(angle));
    };
    return grid(around, across, place, Ends::closed, Ends::open);
}

} // namespace meshes
