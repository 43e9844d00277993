#include "errors/tracked/hole_products.hpp"

#include <algorithm>

#include "util/indexing.hpp"

namespace meshbound {

double HoleProducts::dot(const Lane* p, const Lane* q) const {
    Lane sum = {0, 0};
    for (int i = 0; i < rows_->lanes(); ++i) sum += p[i] * q[i];
    return sum[0] + sum[1];
}

void HoleProducts::enter(const Hole& hole, const std::vector<InnerVertex>& inner) {
    hole_ = &hole;
    inner_ = &inner;
    size_ = hole.size();
    const int lanes = rows_->lanes();
    const double* centre = (*rows_)[hole.candidate];
    ring_rows_.clear();
    for (const std::uint32_t vertex : hole.ring) ring_rows_.push_back((*rows_)[vertex]);
    local_.resize(to_index(size_ * lanes));
    for (int i = 0; i < size_; ++i) {
        const double* row = ring_row(i);
        for (int n = 0; n < lanes; ++n)
            local_[to_index(i * lanes + n)] = BoundedRows::lane(row, n) - BoundedRows::lane(centre, n);
    }
    ring_.resize(to_index(size_ * size_));
    for (int i = 0; i < size_; ++i)
        for (int j = 0; j <= i; ++j)
            ring_[to_index(i * size_ + j)] = ring_[to_index(j * size_ + i)] = dot(local(i), local(j));
    along_.resize(std::max(along_.size(), inner.size() * to_index(size_ + 1))); // never less: growing would clear it
    known_.assign(inner.size(), 0);
}

const double* HoleProducts::vertex(std::size_t inner) {
    double* along = &along_[inner * to_index(size_ + 1)];
    if (!known_[inner]) {
        known_[inner] = 1;
        fill_vertex(inner, along);
    }
    return along;
}

void HoleProducts::fill_vertex(std::size_t inner, double* out) {
    const int lanes = rows_->lanes();
    const double* row = (*rows_)[(*inner_)[inner].vertex];
    const double* centre = (*rows_)[hole_->candidate];
    vertex_.resize(to_index(lanes));
    for (int n = 0; n < lanes; ++n) vertex_[to_index(n)] = BoundedRows::lane(row, n) - BoundedRows::lane(centre, n);
    for (int i = 0; i < size_; ++i) out[i] = dot(vertex_.data(), local(i));
    out[size_] = dot(vertex_.data(), vertex_.data());
}

} // namespace meshbound
