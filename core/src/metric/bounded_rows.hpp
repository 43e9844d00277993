#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "metric/rows.hpp"
#include "util/prefetch.hpp"

namespace meshbound {

/// Two neighbouring components of a row. The compilers' common vector type: one SSE, NEON or WebAssembly SIMD register, and
/// the same arithmetic, so the same bytes, on all of them.
using Lane = double __attribute__((vector_size(16)));

/// The bounded components of the rows, as the inner loops go through them, two at a time: variables with several
/// components first, in whose last lane there may be a scalar, too, then the other scalars side by side.
///
///     position (3), pressure, temperature, energy:   | x y | z p | t e |
class BoundedRows {
public:
    /// The rows outlive it.
    explicit BoundedRows(const Rows& rows);

    const double* operator[](std::uint32_t vertex) const { return (*rows_)[vertex] + begin_; }
    /// Prefetches a row; of a long one the first 16 components.
    void prefetch(std::uint32_t vertex) const {
        meshbound::prefetch((*rows_)[vertex] + begin_prefetched_);
        meshbound::prefetch((*rows_)[vertex] + end_prefetched_);
    }
    int lanes() const { return lanes_; }
    const Multipliers& multipliers() const { return rows_->multipliers(); }
    double variables() const;
    static Lane lane(const double* row, int i) {
        Lane loaded;
        std::memcpy(&loaded, row + 2 * i, sizeof loaded);
        return loaded;
    }

    /// Largest squared ratio to its bound over the variables; `difference(i)` gives lane i of the difference of two rows.
    template <class Difference>
    double squared_ratio(const Difference& difference) const {
        Lane worst = {0, 0};
        const auto include = [&worst](const Lane& squares) { worst = squares > worst ? squares : worst; };
        for (const Vector& vector : vectors_) {
            Lane sum = {0, 0};
            for (int i = vector.first; i < vector.full_end; ++i) {
                const Lane d = difference(i);
                sum += d * d;
            }
            Lane squares = {sum[0] + sum[1], 0};
            if (vector.odd) {
                const Lane d = difference(vector.full_end);
                squares += d * d; // the other half is that of a scalar, or zero
            }
            include(squares);
        }
        for (int i = scalars_; i < lanes_; ++i) {
            const Lane d = difference(i);
            include(d * d);
        }
        return std::max(worst[0], worst[1]);
    }

    /// The variable (0: position) in which a difference is largest.
    template <class Difference>
    std::uint32_t worst_variable(const Difference& difference) const {
        double worst = -1;
        std::uint32_t variable = 0;
        const auto consider = [&](double square, std::uint32_t of_square) {
            if (square <= worst) return;
            worst = square;
            variable = of_square;
        };
        for (const Vector& vector : vectors_) {
            double sum = 0;
            for (int i = vector.first; i < vector.full_end; ++i) {
                const Lane d = difference(i);
                sum += d[0] * d[0] + d[1] * d[1];
            }
            const Lane last = vector.odd ? difference(vector.full_end) : Lane{0, 0};
            consider(sum + last[0] * last[0], vector.variable);
            if (vector.scalar != no_variable) consider(last[1] * last[1], vector.scalar);
        }
        for (std::size_t n = 0; n < scalar_variables_.size(); ++n) {
            const double d = difference(scalars_ + static_cast<int>(n / 2))[n % 2];
            consider(d * d, scalar_variables_[n]);
        }
        return variable;
    }

    /// Calls `include` with the sum over the components of each bounded variable. Sum::add(at(i)) adds lane i;
    /// Sum::total() is the sum of both halves, Sum::half(0) and Sum::half(1) are one each.
    template <class Sum, class At, class Include>
    void sum_by_variable(const At& at, const Include& include) const {
        for (const Vector& vector : vectors_) {
            Sum sum, last;
            for (int i = vector.first; i < vector.full_end; ++i) sum.add(at(i));
            if (vector.odd) last.add(at(vector.full_end));
            auto total = sum.total();
            total.add(last.half(0), 1);
            include(total);
            if (vector.scalar != no_variable) include(last.half(1));
        }
        for (std::size_t n = 0; n < scalar_variables_.size(); n += 2) {
            Sum sum;
            sum.add(at(scalars_ + static_cast<int>(n / 2)));
            include(sum.half(0));
            if (n + 1 < scalar_variables_.size()) include(sum.half(1));
        }
    }

    /// A row less the weighted sum of three others.
    static auto blend_difference(const double* row, const double* p, const double* q, const double* r, double wp,
                                 double wq, double wr) {
        return [=](int i) { return lane(row, i) - (wp * lane(p, i) + wq * lane(q, i) + wr * lane(r, i)); };
    }

    /// The point at share s from u to v less the point at share t from a to b.
    static auto segment_difference(const double* u, const double* v, double s, const double* a, const double* b,
                                   double t) {
        return [=](int i) {
            return (lane(u, i) + s * (lane(v, i) - lane(u, i))) - (lane(a, i) + t * (lane(b, i) - lane(a, i)));
        };
    }

    /// Largest squared ratio of a row against the weighted sum of three others.
    double squared_ratio(const double* row, const double* p, const double* q, const double* r, double wp, double wq,
                         double wr) const {
        return squared_ratio(blend_difference(row, p, q, r, wp, wq, wr));
    }

private:
    static constexpr std::uint32_t no_variable = 0xffffffff;
    struct Vector {
        int first = 0, full_end = 0; // the lanes that it fills alone
        bool odd = false;            // its last component has the first half of the lane after them …
        std::uint32_t variable = 0;
        std::uint32_t scalar = no_variable; // … and this variable, or zero, the second
    };
    Vector& vector_sharing(int lane);

    const Rows* rows_;
    int begin_ = 0; // of the first lane in the row
    int lanes_ = 0;
    int scalars_ = 0;                               // first lane of the other scalars
    int begin_prefetched_ = 0, end_prefetched_ = 0; // components of the row, one on each cache line
    std::vector<Vector> vectors_;
    std::vector<std::uint32_t> scalar_variables_;
};

} // namespace meshbound
