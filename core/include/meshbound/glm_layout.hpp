#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// Arrays of these types are looked at as arrays of numbers, and a program must lay them out as the library was built to. GLM's
/// settings (GLM_FORCE_DEFAULT_ALIGNED_GENTYPES) can pad them: the compiler says so here, instead of reading wrong numbers.
static_assert(sizeof(glm::uvec2) == 2 * sizeof(std::uint32_t), "Meshbound needs glm::uvec2 without padding");
static_assert(sizeof(glm::uvec3) == 3 * sizeof(std::uint32_t), "Meshbound needs glm::uvec3 without padding");
static_assert(sizeof(glm::dvec3) == 3 * sizeof(double), "Meshbound needs glm::dvec3 without padding");
static_assert(alignof(glm::uvec2) == alignof(std::uint32_t), "Meshbound needs glm::uvec2 aligned like a number");
static_assert(alignof(glm::uvec3) == alignof(std::uint32_t), "Meshbound needs glm::uvec3 aligned like a number");
static_assert(alignof(glm::dvec3) == alignof(double), "Meshbound needs glm::dvec3 aligned like a number");
