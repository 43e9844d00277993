#pragma once

#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <vector>

#include "meshbound/verify.hpp"

namespace meshbound {

/// What a failed test prints.
inline std::ostream& operator<<(std::ostream& out, const Judgement& judgement) {
    const auto print = [&out](const char* name, const Deviation& d) {
        out << name << ": " << d.ratio << " of the bound of variable " << d.variable << " (0 is position) in triangle "
            << d.triangle << " at (" << d.position[0] << ", " << d.position[1] << ", " << d.position[2] << "), "
            << d.samples << " samples";
    };
    print("from the original", judgement.from_original);
    print("; from the reduced", judgement.from_reduced);
    return out;
}

} // namespace meshbound

/// The library's own judge (meshbound/verify.hpp), as tests ask it.
namespace judge {

inline const std::size_t usual_samples = meshbound::VerifyOptions{}.samples;

/// Throws std::invalid_argument where the two cannot be compared.
inline meshbound::Verdict verdict_of(const meshbound::Mesh& original, const meshbound::Mesh& reduced,
                                     const std::vector<double>& bounds, const meshbound::VerifyOptions& options = {}) {
    meshbound::Verdict verdict;
    const meshbound::Status status = meshbound::verify(original, reduced, bounds, options, verdict);
    if (!status.ok()) throw std::invalid_argument(status.message);
    return verdict;
}

/// What it says of the surfaces.
inline meshbound::Judgement judge(const meshbound::Mesh& original, const meshbound::Mesh& reduced,
                                  const std::vector<double>& bounds, std::size_t samples = usual_samples,
                                  const std::vector<double>& multipliers = {}) {
    return verdict_of(original, reduced, bounds, {samples, 1, multipliers}).surface;
}

/// What it says of their boundaries.
inline meshbound::Judgement judge_boundary(const meshbound::Mesh& original, const meshbound::Mesh& reduced,
                                           const std::vector<double>& bounds, std::size_t samples = usual_samples,
                                           const std::vector<double>& multipliers = {}) {
    return verdict_of(original, reduced, bounds, {1, samples, multipliers}).boundary;
}

} // namespace judge
