// Makes a level set of balls around particles with OpenVDB, for particle_peers.py, which compiles
// it.
//
//     particles_to_vdb PARTICLES.csv RADIUS VOXEL OUT.vdb
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <openvdb/tools/ParticlesToLevelSet.h>

namespace {

// The particles in the form that OpenVDB asks for.
struct Balls {
    using PosType = openvdb::Vec3R;

    std::vector<PosType> centres;
    double radius = 0;

    std::size_t size() const { return centres.size(); }
    void getPos(std::size_t n, PosType& at) const { at = centres[n]; }
    void getPosRad(std::size_t n, PosType& at, openvdb::Real& r) const {
        at = centres[n];
        r = radius;
    }
};

} // namespace

int main(int count, char** words) {
    if (count != 5) {
        std::fputs("usage: particles_to_vdb PARTICLES.csv RADIUS VOXEL OUT.vdb\n", stderr);
        return 2;
    }
    Balls balls;
    balls.radius = std::atof(words[2]);
    const double voxel = std::atof(words[3]);
    std::ifstream rows(words[1]);
    std::string row;
    std::getline(rows, row);
    while (std::getline(rows, row)) {
        openvdb::Vec3R at;
        if (std::sscanf(row.c_str(), "%lf,%lf,%lf", &at[0], &at[1], &at[2]) == 3)
            balls.centres.push_back(at);
    }
    openvdb::initialize();
    auto level_set = openvdb::createLevelSet<openvdb::FloatGrid>(voxel);
    openvdb::tools::ParticlesToLevelSet<openvdb::FloatGrid> raster(*level_set);
    raster.rasterizeSpheres(balls);
    raster.finalize(true);
    if (raster.getMinCount() > 0) {
        std::fprintf(stderr, "%zu balls are smaller than a voxel shows\n", raster.getMinCount());
        return 1;
    }
    openvdb::io::File(words[4]).write({level_set});
    return 0;
}
