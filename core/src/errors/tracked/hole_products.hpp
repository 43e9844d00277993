#pragma once

#include <cstddef>
#include <vector>

#include "errors/tracked/mapped_content.hpp"
#include "metric/bounded_rows.hpp"
#include "surface/hole.hpp"

namespace meshbound {

/// The dot products of a hole's rows, relative to the candidate's. They are all that nearest points between ring,
/// spokes, diagonals and inner vertices follow from, so that the components are gone through once for each hole, not
/// once for each triangle and diagonal.
class HoleProducts {
public:
    explicit HoleProducts(const BoundedRows& rows) : rows_(&rows) {}

    /// Both outlive the queries.
    void enter(const Hole& hole, const std::vector<InnerVertex>& inner);

    int size() const { return size_; }

    /// The row of a ring index.
    const double* ring_row(int i) const { return ring_rows_[static_cast<std::size_t>(i)]; }

    /// Of the rows of ring indices i and j.
    double ring(int i, int j) const { return ring_[static_cast<std::size_t>(i * size_ + j)]; }

    /// Of an inner vertex with each ring index; behind them its square.
    const double* vertex(std::size_t inner);

private:
    void fill_vertex(std::size_t inner, double* out);
    double dot(const Lane* p, const Lane* q) const;
    /// Where every variable is free there are no lanes, and nothing is stored.
    const Lane* local(int i) const { return local_.data() + static_cast<std::size_t>(i * rows_->lanes()); }

    const BoundedRows* rows_;
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
