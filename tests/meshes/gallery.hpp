#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "meshbound/mesh.hpp"

namespace meshes {

/// A surface with the variables "linear", "wave", "jump" and "whirl", to run every guarantee over.
struct Exhibit {
    std::string name;
    meshbound::Mesh mesh;
    bool closed = true;
};
inline std::ostream& operator<<(std::ostream& out, const Exhibit& exhibit) { return out << exhibit.name; }

/// One of every kind: closed and open, smooth, creased and rough, genus 0 to 3, regular and irregular, one component and
/// several, single and double precision. All are manifolds of some 500 to 2 000 triangles.
std::vector<Exhibit> gallery();

} // namespace meshes
