#include "crossings.hpp"

namespace meshbound {

void Crossings::clear(std::uint32_t current) {
    std::uint32_t id = on_[current];
    while (id != no_index) {
        const std::uint32_t sibling = pool_[id].sibling;
        pool_[id].sibling = unused_;
        unused_ = id;
        id = sibling;
    }
    on_[current] = no_index;
}

std::uint32_t Crossings::add(const Crossing& crossing) {
    std::uint32_t id = unused_;
    if (id == no_index) {
        id = static_cast<std::uint32_t>(pool_.size());
        pool_.push_back(crossing);
    } else {
        unused_ = pool_[id].sibling;
        pool_[id] = crossing;
    }
    pool_[id].sibling = on_[crossing.current];
    on_[crossing.current] = id;
    return id;
}

void Crossings::link(std::uint32_t original, std::uint32_t before, std::uint32_t after) {
    (before == no_index ? first_[original] : pool_[before].next) = after;
    (after == no_index ? last_[original] : pool_[after].previous) = before;
}

} // namespace meshbound
