#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace meshbound {

/// A number held exactly, as a sum of doubles of which none overlaps another, the smallest first; zeros are left out.
/// Source: J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates (1997). Exact
/// as long as nothing over- or underflows.
template <std::size_t Capacity>
struct Expansion {
    std::array<double, Capacity> parts;
    std::size_t count = 0;

    void append(double part) {
        if (part != 0) parts[count++] = part;
    }
    /// -1, 0 or 1.
    int sign() const { return count == 0 ? 0 : parts[count - 1] > 0 ? 1 : -1; }
};

/// A rounded result and what rounding left out.
struct Rounded {
    double value, rest;
};

inline Rounded exact_sum(double a, double b) {
    const double sum = a + b, b_virtual = sum - a;
    return {sum, (a - (sum - b_virtual)) + (b - b_virtual)};
}

/// A double as two halves of at most 26 bits.
inline Rounded split(double a) {
    constexpr double splitter = 134217729; // 2^27 + 1
    const double wide = splitter * a, high = wide - (wide - a);
    return {high, a - high};
}

inline Rounded exact_product(double a, double b) {
    const double product = a * b;
    const Rounded p = split(a), q = split(b);
    const double rest = p.rest * q.rest - (((product - p.value * q.value) - p.rest * q.value) - p.value * q.rest);
    return {product, rest};
}

inline Expansion<2> difference(double a, double b) {
    const Rounded exact = exact_sum(a, -b);
    Expansion<2> e;
    e.append(exact.rest);
    e.append(exact.value);
    return e;
}

template <std::size_t N, std::size_t M>
Expansion<N + M> sum(const Expansion<N>& e, const Expansion<M>& f) {
    Expansion<N + M> total;
    if (e.count + f.count == 0) return total;
    std::size_t i = 0, j = 0;
    const auto smallest_left = [&] {
        const bool from_e = j == f.count || (i < e.count && std::abs(e.parts[i]) < std::abs(f.parts[j]));
        return from_e ? e.parts[i++] : f.parts[j++];
    };
    double carried = smallest_left();
    while (i < e.count || j < f.count) {
        const Rounded exact = exact_sum(carried, smallest_left());
        total.append(exact.rest);
        carried = exact.value;
    }
    total.append(carried);
    return total;
}

template <std::size_t N>
Expansion<2 * N> product(const Expansion<N>& e, double factor) {
    Expansion<2 * N> total;
    double carried = 0;
    for (std::size_t i = 0; i < e.count; ++i) {
        const Rounded term = exact_product(e.parts[i], factor);
        const Rounded low = exact_sum(carried, term.rest);
        total.append(low.rest);
        const Rounded high = exact_sum(term.value, low.value);
        total.append(high.rest);
        carried = high.value;
    }
    total.append(carried);
    return total;
}

template <std::size_t N>
Expansion<4 * N> product(const Expansion<N>& e, const Expansion<2>& f) {
    Expansion<4 * N> total;
    if (f.count == 0) return total;
    const Expansion<2 * N> first = product(e, f.parts[0]);
    return sum(first, f.count == 2 ? product(e, f.parts[1]) : Expansion<2 * N>{});
}

template <std::size_t N>
Expansion<N> negated(Expansion<N> e) {
    for (std::size_t i = 0; i < e.count; ++i) e.parts[i] = -e.parts[i];
    return e;
}

} // namespace meshbound
