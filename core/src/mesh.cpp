#include "meshbound/mesh.hpp"

namespace meshbound {

std::size_t value_count(const Variable& variable) {
    return std::visit([](const auto& values) { return values.size(); }, variable.values);
}

std::size_t vertex_count(const Mesh& mesh) { return value_count(mesh.position) / 3; }

double value_at(const Variable& variable, std::size_t vertex, int component) {
    const std::size_t index =
        vertex * static_cast<std::size_t>(variable.components) + static_cast<std::size_t>(component);
    return std::visit([&](const auto& values) { return static_cast<double>(values[index]); }, variable.values);
}

Variable gather(const Variable& variable, const std::vector<std::uint32_t>& vertices) {
    const auto components = static_cast<std::size_t>(variable.components);
    Variable gathered{variable.name, variable.components, {}, variable.kind};
    std::visit(
        [&](const auto& values) {
            std::decay_t<decltype(values)> picked;
            picked.reserve(vertices.size() * components);
            for (const std::uint32_t vertex : vertices)
                picked.insert(picked.end(), values.begin() + static_cast<std::ptrdiff_t>(vertex * components),
                              values.begin() + static_cast<std::ptrdiff_t>((vertex + std::size_t{1}) * components));
            gathered.values = std::move(picked);
        },
        variable.values);
    return gathered;
}

} // namespace meshbound
