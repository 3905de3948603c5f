#include "scene/particles/read_particles.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "base/file.h"
#include "base/file_text.h"
#include "base/regular_file.h"
#include "scene/error.h"
#include "scene/limits.h"
#include "scene/particles/formats.h"
#include "scene/particles/gunzip.h"

namespace isomotion::scene {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // before a text

using Reader = ParticleTable (*)(const Bytes&, const ParticleRequest&);

Reader reader_of_text(const std::filesystem::path& file) {
    std::filesystem::path name = file.filename();
    if (name.extension() == ".gz") name = name.stem();
    std::string extension = name.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) {
        return 'A' <= c && c <= 'Z' ? char(c - 'A' + 'a') : char(c);
    });
    if (extension == ".xyz") return read_xyz;
    if (extension == ".pdb" || extension == ".ent") return read_pdb;
    for (const char* rows : {".txt", ".dat", ".pts", ".asc"}) {
        if (extension == rows) return read_rows;
    }
    return read_csv;
}

// XYZ without its first two lines.
bool begins_with_a_count(std::string_view text) {
    const std::string_view line = text.substr(0, std::min(text.find('\n'), text.size()));
    const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
    const auto begin =
        std::ranges::find_if_not(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
    const auto end = std::find_if_not(begin, line.end(), is_digit);
    return begin != end &&
           std::all_of(end, line.end(), [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
}

Reader reader_of(std::string_view bytes, const ParticleRequest& request) {
    if (bytes.starts_with("BgeoV")) return read_bgeo;
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return read_ply;
    if (bytes.starts_with("\x93NUMPY")) return read_npy;
    if (bytes.starts_with("# vtk DataFile")) return read_vtk;
    std::string_view text = bytes;
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.starts_with("<?xml") || text.starts_with("<VTKFile")) return read_vtu;
    for (const auto& [begin, what] :
         {std::pair<std::string_view, const char*>(
              "\x7fNSJ", "is a BGEO of Houdini 12 or later; write .bhclassic, or PLY"),
          {"scf1", "is packed by Blosc (.sc); write it unpacked, or by gzip"},
          {"PK\x03\x04", "is a zip, as .npz; store one array with numpy.save"},
          {"\x89HDF", "is HDF5; store PLY, VTK or NPY"},
          {" BDV", "is OpenVDB; its grids are not read"},
          {"ITEM: ", "is a dump of LAMMPS; write it as XYZ or CSV"},
          {"data_", "is CIF; write it as PDB or XYZ"}}) {
        if (bytes.starts_with(begin)) fail_of_file(request, what);
    }
    if (bytes.substr(0, 1 << 16).find('\0') != bytes.npos) {
        fail_of_file(request, "is no format that is read: BGEO (version V), PLY, NPY, legacy VTK, "
                              "VTU, CSV, XYZ or PDB");
    }
    for (const char* record : {"HEADER    ", "CRYST1", "ATOM  ", "HETATM"}) {
        if (text.starts_with(record)) return read_pdb;
    }
    const Reader reader = reader_of_text(request.file);
    if (reader == read_xyz && !begins_with_a_count(text)) return read_rows;
    return reader;
}

// The beginning of a file; nothing if it cannot be read.
std::string beginning_of(const ParticleRequest& request, std::size_t most) {
    std::string bytes(most, '\0');
    try {
        base::RegularFile file(request.file, request.within);
        bytes.resize(file.read(std::as_writable_bytes(std::span(bytes))));
    } catch (const base::FileError&) {
        bytes.clear();
    }
    return bytes;
}

} // namespace

ReadParticles read_particles(const ParticleRequest& request, std::size_t most) {
    std::error_code unknown;
    if (const auto size = std::filesystem::file_size(request.file, unknown);
        !unknown && size > most) {
        fail_of_file(request,
                     fmt::format("has {} bytes; {} are left of the {} of all tables that arrays of "
                                 "a scene name",
                                 size, most, limits::table_bytes));
    }
    return read_particles(request, base::file_text(request.file, most, request.within), most);
}

ReadParticles read_particles(const ParticleRequest& request, std::string bytes, std::size_t most) {
    const bool is_packed = is_gzip(bytes);
    if (is_packed) bytes = gunzip(request, bytes, most);
    const std::size_t size = bytes.size();
    if (bytes.starts_with(byte_order_mark)) bytes.erase(0, byte_order_mark.size());
    const Reader reader = reader_of(bytes, request);
    ReadParticles read{reader(std::make_shared<const std::string>(std::move(bytes)), request),
                       size};
    if (is_packed) read.table.format += ", packed by gzip";
    return read;
}

std::size_t count_particles(const std::filesystem::path& file, const base::Confines& within,
                            std::size_t most, std::size_t& left) {
    ParticleRequest request;
    request.file = file;
    request.within = within;
    request.count_alone = true;
    constexpr std::size_t beginning = 1 << 16;
    std::string bytes = beginning_of(request, beginning);
    if (is_gzip(bytes)) bytes = gunzip(request, bytes, beginning);
    const bool is_whole = bytes.size() < beginning;
    const Reader reader = bytes.empty() ? read_csv : reader_of(bytes, request);
    const bool counts_lines = reader == read_csv || reader == read_rows || reader == read_pdb;
    if (is_whole || !counts_lines) {
        try {
            return reader(std::make_shared<const std::string>(std::move(bytes)), request).count;
        } catch (const SceneError&) { // a header longer than that, or a mistake
        }
    }
    const ReadParticles read = read_particles(request, most);
    left -= std::min(left, read.bytes);
    return read.table.count;
}

} // namespace isomotion::scene
