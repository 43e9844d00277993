#include "meshbound/status.hpp"

namespace meshbound {

std::string_view fault_name(Fault fault) {
    switch (fault) {
    case Fault::none: return "none";
    case Fault::no_triangles: return "no_triangles";
    case Fault::bad_coordinates: return "bad_coordinates";
    case Fault::bad_index: return "bad_index";
    case Fault::non_finite_position: return "non_finite_position";
    case Fault::bad_components: return "bad_components";
    case Fault::wrong_value_count: return "wrong_value_count";
    case Fault::non_finite_value: return "non_finite_value";
    case Fault::empty_name: return "empty_name";
    case Fault::duplicate_name: return "duplicate_name";
    case Fault::unknown_variable: return "unknown_variable";
    case Fault::bad_bound: return "bad_bound";
    case Fault::bound_too_fine: return "bound_too_fine";
    case Fault::bad_option: return "bad_option";
    case Fault::bad_checkpoint: return "bad_checkpoint";
    case Fault::bad_map: return "bad_map";
    case Fault::bad_levels: return "bad_levels";
    case Fault::too_large: return "too_large";
    case Fault::out_of_memory: return "out_of_memory";
    }
    return "unknown";
}

} // namespace meshbound
