#include "particle_writers.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <random>
#include <stdexcept>

#include <fmt/format.h>
#include <zlib.h>

namespace isomotion::scene::particles {
namespace {

template<class T> void put(std::string& to, T value, bool big_endian) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (big_endian != (std::endian::native == std::endian::big))
        std::reverse(bytes, bytes + sizeof(T));
    to.append(bytes, sizeof(T));
}

void put_text(std::string& to, std::string_view text) {
    put(to, std::uint16_t(text.size()), true);
    to += text;
}

std::string base64(std::string_view bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            group =
                group << 8 | (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0u);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const bool filled = k + i > bytes.size();
            text += filled ? '=' : digits[group >> (18 - 6 * i) & 63];
        }
    }
    return text;
}

std::string numbers(const std::array<float, 3>& v) {
    return fmt::format("{} {} {}", v[0], v[1], v[2]);
}

template<class Vectors> std::string raw(const Vectors& vectors, bool big_endian) {
    std::string bytes;
    for (const auto& v : vectors) {
        for (const float number : v) put(bytes, number, big_endian);
    }
    return bytes;
}

template<class T> std::string raw_scalars(const std::vector<T>& values, bool big_endian) {
    std::string bytes;
    for (const T value : values) put(bytes, value, big_endian);
    return bytes;
}

std::string npy(std::string header, const std::string& data) {
    header += std::string(63 - (10 + header.size()) % 64, ' ') + '\n';
    std::string bytes("\x93NUMPY\x01\x00", 8);
    put(bytes, std::uint16_t(header.size()), false);
    return bytes + header + data;
}

std::string packed(const std::string& bytes, bool long_headers, bool big_endian, bool is_base64) {
    constexpr std::size_t block = 40; // several, the last of them shorter
    const std::size_t blocks = (bytes.size() + block - 1) / block;
    std::string header, data;
    const auto head = [&](std::size_t value) {
        if (long_headers) return put(header, std::uint64_t(value), big_endian);
        put(header, std::uint32_t(value), big_endian);
    };
    head(blocks);
    head(block);
    head(bytes.size() % block);
    for (std::size_t k = 0; k < blocks; ++k) {
        const std::string_view part = std::string_view(bytes).substr(k * block, block);
        std::vector<Bytef> out(::compressBound(part.size()));
        uLongf size = out.size();
        ::compress(out.data(), &size, reinterpret_cast<const Bytef*>(part.data()), part.size());
        head(size);
        data.append(reinterpret_cast<const char*>(out.data()), size);
    }
    return is_base64 ? base64(header) + base64(data) : header + data;
}

std::string plain(const std::string& bytes, bool long_headers, bool big_endian, bool is_base64) {
    std::string all;
    if (long_headers)
        put(all, std::uint64_t(bytes.size()), big_endian);
    else
        put(all, std::uint32_t(bytes.size()), big_endian);
    all += bytes;
    return is_base64 ? base64(all) : all;
}

} // namespace

Cloud cloud(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> eighths(-8000, 8000);
    const auto number = [&] { return float(eighths(random)) / 8; };
    Cloud cloud;
    for (int k = 0; k < count; ++k) {
        cloud.position.push_back({number(), number(), number()});
        cloud.velocity.push_back({number(), number(), number()});
        cloud.id.push_back(1'000'000 + 7 * k); // no float holds all of them far above 2^24
        cloud.mass.push_back(number());
    }
    std::shuffle(cloud.id.begin(), cloud.id.end(), random);
    return cloud;
}

std::string bgeo(const Cloud& cloud) {
    std::string bytes = "BgeoV";
    const auto whole = [&](std::int32_t value) { put(bytes, value, true); };
    whole(5);
    whole(std::int32_t(cloud.count()));
    for (const std::int32_t value : {1, 0, 0, 4, 0, 1, 0}) whole(value);
    const auto attribute = [&](std::string_view name, std::uint16_t size, std::int32_t kind) {
        put_text(bytes, name);
        put(bytes, size, true);
        whole(kind);
        if (kind == 4) return;
        for (int k = 0; k < size; ++k) whole(0);
    };
    attribute("v", 3, 5);
    attribute("id", 1, 1);
    attribute("kind", 1, 4);
    whole(2);
    put_text(bytes, "water");
    put_text(bytes, "spray");
    attribute("mass", 1, 0);
    for (std::size_t k = 0; k < cloud.count(); ++k) {
        for (const float x : cloud.position[k]) put(bytes, x, true);
        put(bytes, 1.0f, true);
        for (const float x : cloud.velocity[k]) put(bytes, x, true);
        whole(cloud.id[k]);
        whole(std::int32_t(k % 2));
        put(bytes, cloud.mass[k], true);
    }
    put_text(bytes, "generator");
    put(bytes, std::int16_t(1), true);
    whole(4);
    whole(1);
    put_text(bytes, "papi");
    whole(0x8000);
    whole(std::int32_t(cloud.count()));
    for (std::size_t k = 0; k < cloud.count(); ++k) put(bytes, std::uint16_t(k), true);
    whole(0);
    return bytes + std::string("\x00\xff", 2);
}

std::string ply(const Cloud& cloud, const std::string& format, bool faces) {
    const bool is_ascii = format == "ascii", big = format == "binary_big_endian";
    std::string bytes = "ply\nformat " + format + " 1.0\ncomment by hand\n";
    if (faces) {
        bytes += "element camera 1\nproperty double width\nelement face 2\n"
                 "property list uchar int vertex_indices\nproperty uchar flag\n";
    }
    bytes += fmt::format("element vertex {}\nproperty float x\nproperty float y\n"
                         "property float z\nproperty int id\nproperty double vx\n"
                         "property float vy\nproperty float vz\nproperty float mass\n"
                         "property uchar red\nend_header\n",
                         cloud.count());
    if (faces && is_ascii) bytes += "2.5\n3 0 1 2 9\n2 0 1 8\n";
    if (faces && !is_ascii) {
        put(bytes, 2.5, big);
        for (const int corners : {3, 2}) {
            put(bytes, std::uint8_t(corners), big);
            for (int k = 0; k < corners; ++k) put(bytes, std::int32_t(k), big);
            put(bytes, std::uint8_t(9), big);
        }
    }
    for (std::size_t k = 0; k < cloud.count(); ++k) {
        if (is_ascii) {
            bytes += fmt::format("{} {} {} {} 7\n", numbers(cloud.position[k]), cloud.id[k],
                                 numbers(cloud.velocity[k]), cloud.mass[k]);
            continue;
        }
        for (const float x : cloud.position[k]) put(bytes, x, big);
        put(bytes, cloud.id[k], big);
        put(bytes, double(cloud.velocity[k][0]), big);
        put(bytes, cloud.velocity[k][1], big);
        put(bytes, cloud.velocity[k][2], big);
        put(bytes, cloud.mass[k], big);
        put(bytes, std::uint8_t(7), big);
    }
    return bytes;
}

std::string npy_rows(const Cloud& cloud, bool by_columns, bool big_endian) {
    std::string data;
    const auto number = [&](std::size_t k, std::size_t c) {
        return double(c < 3 ? cloud.position[k][c] : cloud.velocity[k][c - 3]);
    };
    for (std::size_t k = 0; k < 6 * cloud.count(); ++k) {
        const std::size_t row = by_columns ? k % cloud.count() : k / 6;
        const std::size_t column = by_columns ? k / cloud.count() : k % 6;
        put(data, number(row, column), big_endian);
    }
    return npy(fmt::format("{{'descr': '{}f8', 'fortran_order': {}, 'shape': ({}, 6), }}",
                           big_endian ? '>' : '<', by_columns ? "True" : "False", cloud.count()),
               data);
}

std::string npy_records(const Cloud& cloud) {
    std::string data;
    for (std::size_t k = 0; k < cloud.count(); ++k) {
        for (const float x : cloud.position[k]) put(data, x, false);
        put(data, std::uint32_t(0xffffffff), false); // padding, no number
        put(data, std::int64_t(cloud.id[k]), false);
        for (const float x : cloud.velocity[k]) put(data, x, true);
        put(data, cloud.mass[k], false);
    }
    return npy(fmt::format("{{'descr': [('position', '<f4', (3,)), ('', '|V4'), ('id', '<i8'), "
                           "('velocity', '>f4', (3,)), ('mass', '<f4')], 'fortran_order': False, "
                           "'shape': ({},), }}",
                           cloud.count()),
               data);
}

std::string vtk(const Cloud& cloud, bool is_ascii, bool is_grid) {
    const std::size_t n = cloud.count();
    std::string bytes =
        fmt::format("# vtk DataFile Version {}\nby hand\n{}\nDATASET {}\n", is_grid ? "5.1" : "3.0",
                    is_ascii ? "ASCII" : "BINARY", is_grid ? "UNSTRUCTURED_GRID" : "POLYDATA");
    const auto vectors = [&](const auto& all) {
        for (const auto& v : all) bytes += is_ascii ? numbers(v) + "\n" : "";
        if (!is_ascii) bytes += raw(all, true) + "\n";
    };
    const auto scalars = [&](const auto& all) {
        for (const auto value : all) bytes += is_ascii ? fmt::format("{}\n", value) : "";
        if (!is_ascii) bytes += raw_scalars(all, true) + "\n";
    };
    bytes += "FIELD FieldData 1\nTIME 1 1 double\n";
    scalars(std::vector<double>{0.5});
    bytes += fmt::format("POINTS {} float\n", n);
    vectors(cloud.position);
    std::vector<std::int64_t> offsets, corners;
    std::vector<std::int32_t> cells, types;
    for (std::size_t k = 0; k < n; ++k) {
        offsets.push_back(std::int64_t(k));
        corners.push_back(std::int64_t(k));
        cells.insert(cells.end(), {1, std::int32_t(k)});
        types.push_back(1);
    }
    offsets.push_back(std::int64_t(n));
    if (is_grid) {
        bytes += fmt::format("CELLS {} {}\nOFFSETS vtktypeint64\n", n + 1, n);
        scalars(offsets);
        bytes += "CONNECTIVITY vtktypeint64\n";
        scalars(corners);
        bytes += fmt::format("CELL_TYPES {}\n", n);
        scalars(types);
    } else {
        bytes += fmt::format("VERTICES {} {}\n", n, 2 * n);
        scalars(cells);
    }
    bytes += fmt::format("CELL_DATA {}\nSCALARS kind int\nLOOKUP_TABLE default\n", n);
    scalars(types);
    bytes += fmt::format("POINT_DATA {}\nVECTORS velocity float\n", n);
    vectors(cloud.velocity);
    bytes += "SCALARS mass float 1\nLOOKUP_TABLE default\n";
    scalars(cloud.mass);
    bytes += fmt::format("METADATA\nINFORMATION 0\n\nFIELD FieldData 1\nid 1 {} int\n", n);
    scalars(cloud.id);
    return bytes;
}

std::string vtu(const Cloud& cloud, Vtu how, bool is_packed, bool long_headers, bool big_endian) {
    const std::size_t n = cloud.count();
    std::string appended;
    const bool is_base64 = how != Vtu::appended_raw;
    const auto array = [&](std::string_view name, std::string_view type, int components,
                           const std::string& text, const std::string& bytes) {
        std::string tag = fmt::format("        <DataArray type=\"{}\" Name=\"{}\" "
                                      "NumberOfComponents=\"{}\" ",
                                      type, name, components);
        if (how == Vtu::ascii) return tag + "format=\"ascii\">\n" + text + "</DataArray>\n";
        const std::string data = is_packed ? packed(bytes, long_headers, big_endian, is_base64)
                                           : plain(bytes, long_headers, big_endian, is_base64);
        if (how == Vtu::inline_base64)
            return tag + "format=\"binary\">\n  " + data + "\n</DataArray>\n";
        tag += fmt::format("format=\"appended\" offset=\"{}\"/>\n", appended.size());
        appended += data;
        return tag;
    };
    const auto words = [](const auto& values) {
        std::string text;
        for (const auto value : values) text += fmt::format("{} ", value);
        return text;
    };
    std::string places, velocities;
    for (std::size_t k = 0; k < n; ++k) {
        places += numbers(cloud.position[k]) + "\n";
        velocities += numbers(cloud.velocity[k]) + "\n";
    }
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<!-- by hand -->\n<VTKFile type=\"UnstructuredGrid\" "
        "version=\"1.0\" byte_order=\"{}\"{}{}>\n  <UnstructuredGrid>\n    <Piece "
        "NumberOfPoints=\"{}\" NumberOfCells=\"0\">\n      <PointData>\n",
        big_endian ? "BigEndian" : "LittleEndian", long_headers ? " header_type=\"UInt64\"" : "",
        is_packed ? " compressor=\"vtkZLibDataCompressor\"" : "", n);
    text += array("mass", "Float32", 1, words(cloud.mass), raw_scalars(cloud.mass, big_endian));
    text += array("velocity", "Float32", 3, velocities, raw(cloud.velocity, big_endian));
    text += array("id", "Int32", 1, words(cloud.id), raw_scalars(cloud.id, big_endian));
    text += "      </PointData>\n      <CellData></CellData>\n      <Points>\n";
    text += array("Points", "Float32", 3, places, raw(cloud.position, big_endian));
    text += "      </Points>\n    </Piece>\n  </UnstructuredGrid>\n";
    if (!appended.empty()) {
        text += fmt::format("  <AppendedData encoding=\"{}\">\n   _{}\n  </AppendedData>\n",
                            is_base64 ? "base64" : "raw", appended);
    }
    return text + "</VTKFile>\n";
}

std::string xyz(const Cloud& cloud) {
    std::string text = fmt::format("{}\nby hand: 3 4 5\n", cloud.count());
    for (std::size_t k = 0; k < cloud.count(); ++k)
        text += fmt::format("{}   {}\n", k % 2 ? "He" : "H", numbers(cloud.position[k]));
    return text;
}

std::string rows(const Cloud& cloud) {
    std::string text = "# by hand\n\n";
    for (std::size_t k = 0; k < cloud.count(); ++k) {
        text += fmt::format(" {}\t{}\n", numbers(cloud.position[k]), numbers(cloud.velocity[k]));
    }
    return text;
}

std::string csv(const Cloud& cloud) {
    std::string text = "id,x,y,z,vx,vy,vz,mass\n";
    for (std::size_t k = 0; k < cloud.count(); ++k) {
        const auto &p = cloud.position[k], &v = cloud.velocity[k];
        text += fmt::format("{},{},{},{},{},{},{},{}\n", cloud.id[k], p[0], p[1], p[2], v[0], v[1],
                            v[2], cloud.mass[k]);
    }
    return text;
}

std::string gzip(std::string_view bytes) {
    z_stream stream{};
    if (::deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::runtime_error("no deflate");
    std::string packed(::deflateBound(&stream, bytes.size()) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = uInt(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = uInt(packed.size());
    const int result = ::deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    ::deflateEnd(&stream);
    if (result != Z_STREAM_END) throw std::runtime_error("not all was packed");
    return packed;
}

std::vector<Sample> samples(const Cloud& cloud) {
    std::vector<Sample> all{
        {"Bgeo", "p.csv", bgeo(cloud)},
        {"BgeoPacked", "p.bgeo", gzip(bgeo(cloud))},
        {"PlyAscii", "p", ply(cloud, "ascii"), true},
        {"PlyAsciiBehindFaces", "p.xyz", ply(cloud, "ascii", true), true},
        {"PlyLittle", "p.ply", ply(cloud, "binary_little_endian")},
        {"PlyBig", "p.txt", ply(cloud, "binary_big_endian")},
        {"PlyBehindFaces", "p.ply", ply(cloud, "binary_big_endian", true)},
        {"NpyRows", "p.csv", npy_rows(cloud, false, false)},
        {"NpyColumnsBig", "p.npy", npy_rows(cloud, true, true)},
        {"NpyRecords", "p.npy", npy_records(cloud)},
        {"VtkAscii", "p.csv", vtk(cloud, true, false), true},
        {"VtkAsciiGrid", "p.vtk", vtk(cloud, true, true), true},
        {"VtkBinary", "p.xyz", vtk(cloud, false, false)},
        {"VtkBinaryGrid", "p.vtk", vtk(cloud, false, true)},
        {"VtuAscii", "p.csv", vtu(cloud, Vtu::ascii, false), true},
        {"Xyz", "p.XYZ", xyz(cloud), true},
        {"RowsAsXyz", "p.xyz", rows(cloud), true},
        {"Rows", "p.dat", rows(cloud), true},
        {"Csv", "p.csv", csv(cloud), true},
        {"CsvPacked", "p.csv.gz", gzip(csv(cloud))},
    };
    for (const bool packed : {false, true}) {
        for (const bool large : {false, true}) {
            const std::string name =
                std::string(packed ? "Packed" : "Plain") + (large ? "LongBig" : "");
            all.push_back({"VtuInline" + name, "p.vtu",
                           vtu(cloud, Vtu::inline_base64, packed, large, large)});
            all.push_back({"VtuAppended" + name, "p.vtu",
                           vtu(cloud, Vtu::appended_base64, packed, large, large)});
            all.push_back(
                {"VtuRaw" + name, "p.csv", vtu(cloud, Vtu::appended_raw, packed, large, large)});
        }
    }
    return all;
}

} // namespace isomotion::scene::particles
