#include "meshbound/mesh.hpp"

namespace meshbound {
namespace {

/// So many numbers for each vertex.
Values gather(const Values& values, std::size_t count, const std::vector<std::uint32_t>& vertices) {
    return std::visit(
        [&](const auto& numbers) -> Values {
            std::decay_t<decltype(numbers)> picked;
            picked.reserve(vertices.size() * count);
            for (const std::uint32_t vertex : vertices)
                picked.insert(picked.end(), numbers.begin() + static_cast<std::ptrdiff_t>(vertex * count),
                              numbers.begin() + static_cast<std::ptrdiff_t>((vertex + std::size_t{1}) * count));
            return picked;
        },
        values);
}

} // namespace

std::size_t value_count(const VariableView& variable) {
    return std::visit([](const auto& values) { return values.size(); }, variable.values);
}

std::size_t vertex_count(const Mesh& mesh) { return value_count(mesh.position) / 3; }

double value_at(const VariableView& variable, std::size_t vertex, int component) {
    const std::size_t index =
        vertex * static_cast<std::size_t>(variable.components) + static_cast<std::size_t>(component);
    return std::visit([&](const auto& values) { return static_cast<double>(values[index]); }, variable.values);
}

Variable gather(const Variable& variable, const std::vector<std::uint32_t>& vertices) {
    const auto components = static_cast<std::size_t>(variable.components);
    return {variable.name, variable.components, gather(variable.values, components, vertices), variable.kind};
}

Position gather(const Position& position, const std::vector<std::uint32_t>& vertices) {
    return {gather(position.values, 3, vertices)};
}

} // namespace meshbound
