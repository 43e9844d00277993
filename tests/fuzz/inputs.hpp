#pragma once

#include <cstddef>
#include <cstdint>

#include "meshbound/meshbound.hpp"

/// Meshes, bounds and options that nobody would make on purpose, from the bytes of a fuzzer.
namespace fuzz {

/// Reads the fuzzer's bytes as whatever is wanted next; zeros when they are used up.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

    std::uint8_t byte();
    int signed_byte() { return static_cast<signed char>(byte()); }
    /// True once in so many times.
    bool once_in(int times) { return byte() % times == 1; }
    /// Mostly small whole numbers, so that vertices coincide and lie on lines; sometimes very large, very small or any bits.
    double number();

private:
    double raw_double();

    const std::uint8_t* data_;
    std::size_t left_;
};

/// Pieces of a grid whose corners lie where they belong or anywhere, with triangles on one another, seams, labels and a
/// variable "focus", or without.
meshbound::Mesh make_mesh(Bytes& bytes);
meshbound::Bounds make_bounds(Bytes& bytes);
meshbound::Options make_options(Bytes& bytes, const meshbound::Mesh& mesh);

} // namespace fuzz
