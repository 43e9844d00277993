#pragma once

#include <cstddef>
#include <vector>

#include "surface/hole.hpp"
#include "errors/tracked/hole_content.hpp"
#include "metric/measured_rows.hpp"

namespace meshbound {

/// The joint rows of a hole: those of its ring and, taken from the candidate's, their dot products. Nearest places between
/// ring, spokes, diagonals and inner vertices follow from these numbers alone, so that the components are gone through once a
/// hole, not once for every triangle and diagonal that is asked about.
class HoleProducts {
public:
    explicit HoleProducts(const MeasuredRows& rows) : rows_(&rows) {}

    /// Both outlive what is asked next.
    void enter(const Hole& hole, const std::vector<InnerVertex>& inner);

    int size() const { return size_; }

    /// The row of a ring position.
    const double* ring_row(int i) const { return ring_rows_[static_cast<std::size_t>(i)]; }

    /// Of the rows of ring positions i and j.
    double ring(int i, int j) const { return ring_[static_cast<std::size_t>(i * size_ + j)]; }

    /// Of an inner vertex with each ring position; behind them its square.
    const double* vertex(std::size_t inner);

private:
    void fill_vertex(std::size_t inner, double* out);
    double dot(const Lane* p, const Lane* q) const;
    /// Where every variable is free there are no lanes, and nothing is stored.
    const Lane* local(int i) const { return local_.data() + static_cast<std::size_t>(i * rows_->lanes()); }

    const MeasuredRows* rows_;
    const Hole* hole_ = nullptr;
    const std::vector<InnerVertex>* inner_ = nullptr;
    int size_ = 0;
    std::vector<const double*> ring_rows_;
    std::vector<Lane> local_;   // [i * lanes + lane]: ring rows less the candidate's
    std::vector<Lane> vertex_;  // scratch: one row less the candidate's
    std::vector<double> ring_;  // [i * size + j]
    std::vector<double> along_; // [inner * (size + 1) + i]
    std::vector<char> known_;   // by inner vertex: its part of along_ is filled
};

} // namespace meshbound
