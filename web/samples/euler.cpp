#include "euler.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

#include "pencil.hpp"

namespace euler {
namespace {

/// Fraction of a cell that the fastest wave may cross in a step.
constexpr double courant_number = 0.8;

/// Points along each axis at which a cell samples the initial state.
constexpr int initial_samples = 4;

/// Rows side by side in memory that are handled together, so that every cache line is fetched once.
constexpr int bundle = 16;

std::array<double, variables> conserved_of(const Primitive& state, double gamma) {
    std::array<double, variables> result{};
    double kinetic = 0;
    result[0] = state.density;
    for (int c = 0; c < 3; ++c) {
        const double velocity = state.velocity[c];
        result[1 + c] = state.density * velocity;
        kinetic += 0.5 * state.density * velocity * velocity;
    }
    result[4] = state.pressure / (gamma - 1) + kinetic;
    for (int t = 0; t < tracers; ++t) {
        result[5 + t] = double(state.density) * state.fraction[t];
    }
    return result;
}

/// Calls work(first, last) for `threads` parts of [0, count) at once.
template <typename Work>
void in_parallel(int count, int threads, const Work& work) {
    std::vector<std::thread> others;
    for (int t = 1; t < threads; ++t) {
        others.emplace_back(work, count * t / threads, count * (t + 1) / threads);
    }
    work(0, count / threads);
    for (auto& other : others) {
        other.join();
    }
}

/// How the rows along one axis lie in memory. Rows of one layer begin side by side, `next_row` apart.
struct Rows {
    int cells, rows, layers;
    std::size_t next_cell, next_row, next_layer;
};

Rows rows_along(int axis, const std::array<int, 3>& cells) {
    const std::array<std::size_t, 3> stride = {1, std::size_t(cells[0]), std::size_t(cells[0]) * cells[1]};
    const int row_axis = axis == 0 ? 1 : 0;
    const int layer_axis = axis == 2 ? 1 : 2;
    return {cells[axis], cells[row_axis], cells[layer_axis], stride[axis], stride[row_axis], stride[layer_axis]};
}

/// Calls copy(number in the box, number in the row) for every cell of some rows side by side, in memory order.
template <typename Copy>
void for_each_cell(const Rows& rows, int width, float* box, const std::array<float*, bundle>& lanes, const Copy& copy) {
    if (rows.next_cell == 1) {
        for (int lane = 0; lane < width; ++lane) {
            for (int cell = 0; cell < rows.cells; ++cell) {
                copy(box[lane * rows.next_row + cell], lanes[lane][cell]);
            }
        }
        return;
    }
    for (int cell = 0; cell < rows.cells; ++cell) {
        for (int lane = 0; lane < width; ++lane) {
            copy(box[cell * rows.next_cell + lane], lanes[lane][cell]);
        }
    }
}

} // namespace

Flow::Flow(const Grid& grid, double gamma, Boundary boundary, const InitialState& state, int threads)
    : grid_(grid), gamma_(gamma), boundary_(boundary), threads_(threads) {
    for (auto& quantity : conserved_) {
        quantity.resize(grid.size());
    }
    in_parallel(grid.cells[2], threads_, [&](int first, int last) {
        std::size_t cell = std::size_t(first) * grid.cells[0] * grid.cells[1];
        for (int k = first; k < last; ++k) {
            for (int j = 0; j < grid.cells[1]; ++j) {
                for (int i = 0; i < grid.cells[0]; ++i, ++cell) {
                    fill(cell, {i, j, k}, state);
                }
            }
        }
    });
}

void Flow::fill(std::size_t cell, const std::array<int, 3>& index, const InitialState& state) {
    constexpr int samples = initial_samples * initial_samples * initial_samples;
    std::array<double, variables> sum{};
    for (int s = 0; s < samples; ++s) {
        const std::array<int, 3> part = {s % initial_samples, s / initial_samples % initial_samples,
                                         s / (initial_samples * initial_samples)};
        std::array<double, 3> place{};
        for (int axis = 0; axis < 3; ++axis) {
            place[axis] = grid_.origin[axis] + grid_.spacing * (index[axis] + (part[axis] + 0.5) / initial_samples);
        }
        const auto sampled = conserved_of(state(place[0], place[1], place[2]), gamma_);
        for (int variable = 0; variable < variables; ++variable) {
            sum[variable] += sampled[variable];
        }
    }
    for (int variable = 0; variable < variables; ++variable) {
        conserved_[variable][cell] = float(sum[variable] / samples);
    }
}

int Flow::advance(double end) {
    int steps = 0;
    // Steps come in pairs of one length, the second with the axes in reverse: that makes the splitting second order.
    for (double time = 0; time < end; steps += 2) {
        const double longest = courant_number * grid_.spacing / fastest_wave();
        const bool last = time + 2 * longest >= end;
        const double dt = last ? 0.5 * (end - time) : longest;
        step(dt, {0, 1, 2});
        step(dt, {2, 1, 0});
        time = last ? end : time + 2 * dt;
    }
    return steps;
}

void Flow::step(double dt, const std::array<int, 3>& axes) {
    for (const int axis : axes) {
        sweep(axis, float(dt / grid_.spacing));
    }
}

void Flow::sweep(int axis, float dt_over_spacing) {
    const Rows rows = rows_along(axis, grid_.cells);
    // The row's own direction comes first.
    const std::array<int, variables> order = {0, 1 + axis, 1 + (axis + 1) % 3, 1 + (axis + 2) % 3, 4, 5, 6};
    const auto work = [&](int first, int last) {
        std::vector<Pencil> pencils(bundle, Pencil(rows.cells));
        for (int layer = first; layer < last; ++layer) {
            for (int row = 0; row < rows.rows; row += bundle) {
                const int width = std::min(bundle, rows.rows - row);
                const auto copy_all = [&](const auto& copy) {
                    for (int variable = 0; variable < variables; ++variable) {
                        float* box = conserved_[order[variable]].data() + layer * rows.next_layer + row * rows.next_row;
                        std::array<float*, bundle> lanes{};
                        for (int lane = 0; lane < width; ++lane) {
                            lanes[lane] = pencils[lane].conserved(variable);
                        }
                        for_each_cell(rows, width, box, lanes, copy);
                    }
                };
                copy_all([](float& in_box, float& in_row) { in_row = in_box; });
                for (int lane = 0; lane < width; ++lane) {
                    pencils[lane].step(dt_over_spacing, float(gamma_), boundary_);
                }
                copy_all([](float& in_box, float& in_row) { in_box = in_row; });
            }
        }
    };
    in_parallel(rows.layers, threads_, work);
}

double Flow::fastest_wave() const {
    const int layers = grid_.cells[2];
    const std::size_t layer_size = grid_.size() / layers;
    std::vector<float> fastest(layers, 0.0F); // a number a layer: the maximum does not depend on the threads
    in_parallel(layers, threads_, [&](int first, int last) {
        for (int layer = first; layer < last; ++layer) {
            for (std::size_t cell = layer * layer_size; cell < (layer + 1) * layer_size; ++cell) {
                const Primitive state = at(cell);
                const float sound = std::sqrt(float(gamma_) * state.pressure / state.density);
                for (const float velocity : state.velocity) {
                    fastest[layer] = std::max(fastest[layer], std::fabs(velocity) + sound);
                }
            }
        }
    });
    return *std::max_element(fastest.begin(), fastest.end());
}

Primitive Flow::at(std::size_t cell) const {
    Primitive state;
    state.density = conserved_[0][cell];
    float kinetic = 0;
    for (int c = 0; c < 3; ++c) {
        state.velocity[c] = conserved_[1 + c][cell] / state.density;
        kinetic += 0.5F * conserved_[1 + c][cell] * state.velocity[c];
    }
    state.pressure =
        (float(gamma_) - 1.0F) * std::max(conserved_[4][cell] - kinetic, smallest_pressure_to_kinetic * kinetic);
    for (int t = 0; t < tracers; ++t) {
        state.fraction[t] = conserved_[5 + t][cell] / state.density;
    }
    return state;
}

Totals Flow::totals() const {
    const auto sum = [&](int variable) {
        double total = 0;
        for (const float value : conserved_[variable]) {
            total += value;
        }
        return total * grid_.spacing * grid_.spacing * grid_.spacing;
    };
    Totals totals{sum(0), sum(4), {}};
    for (int t = 0; t < tracers; ++t) {
        totals.partial_mass[t] = sum(5 + t);
    }
    return totals;
}

} // namespace euler
