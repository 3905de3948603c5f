#include "scene/reading/arrays.h"

#include <algorithm>
#include <deque>
#include <map>

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/reading/element_table.h"
#include "scene/reading/named_file.h"
#include "scene/reading/names.h"
#include "scene/reading/numbered_files.h"

namespace isomotion::scene {
namespace {

animation::FieldSource read_field(const toml::node& node, const std::string& key) {
    if (node.is_number()) return read_finite(node, key);
    if (const auto text = node.value<std::string>()) return animation::Expression{*text};
    if (const toml::array* list = node.as_array()) {
        std::vector<double> values;
        for (std::size_t k = 0; k < list->size(); ++k) {
            values.push_back(read_finite(*list->get(k), fmt::format("{}[{}]", key, k)));
        }
        return values;
    }
    fail(node, key, "must be a number, an expression in t, i and n, or a list of numbers");
}

// One array as its tables write it, not yet understood.
struct ArrayNodes {
    const toml::node* place = nullptr;
    const toml::node* count = nullptr;
    const toml::table* data = nullptr; // the table that names a file
    std::vector<std::string> order;    // of the fields
    std::map<std::string, const toml::node*> fields;
};

bool is_of_the_file(const std::string& name) {
    return name == "file" || name == "columns" || name == "interpolation" ||
           name == "extrapolate" || name == "outside" || name == "first_file";
}

void gather(const toml::table& table, const std::string& key, ArrayNodes& nodes) {
    nodes.place = &table;
    if (table.contains("file")) {
        nodes.data = &table;
        nodes.count = nullptr;
        std::erase_if(nodes.order, [&](const std::string& field) {
            return nodes.fields.at(field)->is_array() && nodes.fields.erase(field);
        });
    }
    for (const auto& [name_key, node] : table) {
        const std::string name(name_key.str());
        if (name == "count") {
            nodes.count = &node;
            continue;
        }
        if (nodes.data == &table && is_of_the_file(name)) continue;
        check_name(name, node, key + "." + name);
        if (!nodes.fields.count(name)) nodes.order.push_back(name);
        nodes.fields[name] = &node;
    }
}

int read_count(const toml::node& node, const std::string& key) {
    const auto count = node.value_exact<std::int64_t>();
    if (!count || *count < 0 || *count > limits::elements) {
        fail(node, key, fmt::format("must be an integer from 0 to {}", limits::elements));
    }
    return int(*count);
}

TableOptions read_data(const ArrayNodes& nodes, const std::string& key,
                       const base::Confines& within) {
    Section section(*nodes.data, key);
    TableOptions options;
    options.most = nodes.count ? read_count(*nodes.count, key + ".count") : limits::elements;
    options.counts_files = !nodes.count;
    const toml::node& file = *section.find("file");
    options.file = beside(file, *section.text("file"));
    options.within = confines_of(file, within);
    const int first_file = section.integer("first_file", 0, limits::frames).value_or(1);
    for (const NumberedFile& one :
         numbered_files(file, key + ".file", options.file, options.within))
        options.frames.emplace_back(std::int64_t(one.number) - first_file + 1, one.file);
    if (options.frames.empty()) {
        options.file = named_file(file, key + ".file", std::array{options.file}, options.within);
        if (const toml::node* first = section.find("first_file")) {
            fail(*first, key + ".first_file",
                 "is the number of the file that frame 1 shows; the file's name has no place for "
                 "one, such as ####");
        }
    }
    if (auto columns = section.section("columns")) {
        for (const auto& [name, node] : columns->table()) {
            const std::string field(name.str());
            check_name(field, node, columns->dotted(field));
            options.columns[field] = *columns->text(field);
        }
    }
    if (const auto text = section.text("interpolation")) {
        using enum animation::ElementSamples::Interpolation;
        if (*text == "linear") options.interpolation = linear;
        if (*text == "hold") options.interpolation = hold;
        if (*text == "hermite") options.interpolation = hermite;
        if (!options.interpolation) {
            fail(*section.find("interpolation"), key + ".interpolation",
                 fmt::format("must be linear, hold or hermite, not '{}'", *text));
        }
    }
    return options;
}

// The tables of a scene. A file that several arrays name is read once for all of them; arrays that
// name it alike share what they have of it.
class Tables {
public:
    explicit Tables(const animation::Timeline& timeline)
        : timeline_(timeline) {}

    // Call this for all tables before the first is read.
    void add(const TableOptions& options) {
        File& file = file_of(options);
        if (std::ranges::find(file.asked, options) == file.asked.end())
            file.asked.push_back(options);
    }
    const ElementTable& read(const TableOptions& options) {
        File& file = file_of(options);
        if (file.tables.empty()) file.tables = read_element_tables(file.asked, timeline_, budget_);
        const auto k = std::ranges::find(file.asked, options) - file.asked.begin();
        return file.tables[std::size_t(k)];
    }
    const animation::Timeline& timeline() const { return timeline_; }

private:
    struct File {
        std::vector<TableOptions> asked;
        std::vector<ElementTable> tables; // of each
    };

    File& file_of(const TableOptions& options) {
        const auto known = std::ranges::find_if(files_, [&](const File& file) {
            const TableOptions& first = file.asked.front();
            return first.file == options.file && first.within == options.within &&
                   first.frames == options.frames;
        });
        return known != files_.end() ? *known : files_.emplace_back();
    }

    const animation::Timeline& timeline_;
    TableBudget budget_{limits::table_bytes, limits::table_values};
    std::deque<File> files_;
};

// Frames beyond the data would show its ends, standing still.
void check_times(const toml::table& table, const std::string& key, const TableOptions& options,
                 const ElementTable& read, const animation::Timeline& timeline) {
    Section section(table, key);
    const auto extrapolate = section.text("extrapolate");
    if (extrapolate && *extrapolate != "hold") {
        fail(*section.find("extrapolate"), section.dotted("extrapolate"),
             fmt::format("must be hold: the first and the last elements stay, not '{}'",
                         *extrapolate));
    }
    const animation::ElementSamples& samples = *read.samples;
    if (extrapolate || samples.first_time() == samples.last_time()) return;
    const char* first_file =
        options.frames.empty() ? "" : ", or first_file = the number of the file of frame 1";
    if (samples.first_time() > timeline.time(1)) {
        throw SceneError(fmt::format("{}: begins at t = {}, after the scene's first frame; begin "
                                     "at 0, or give the array extrapolate = \"hold\"{}",
                                     read.first, samples.first_time(), first_file));
    }
    if (samples.last_time() < timeline.time(timeline.frames)) {
        throw SceneError(
            fmt::format("{}: ends at t = {}, but frame {} of the scene is at t = "
                        "{}; lower time.frames, or give the array extrapolate = \"hold\"{}",
                        read.last, samples.last_time(), timeline.frames,
                        timeline.time(timeline.frames), first_file));
    }
}

// The columns of a file become fields; a field that the scene writes itself goes before.
void add_data(const ArrayNodes& nodes, const std::string& key, const TableOptions& options,
              Tables& tables, TrackTable& tracks, animation::Array& array) {
    const ElementTable& table = tables.read(options);
    check_times(*nodes.data, key, options, table, tables.timeline());
    array.samples = table.samples;
    array.count = nodes.count ? options.most : table.samples->most();
    for (std::size_t k = 0; k < table.fields.size(); ++k) {
        const std::string& field = table.fields[k];
        if (nodes.fields.count(field)) continue;
        array.fields.push_back({field, animation::Column{k}});
        tracks.place(array.name + "." + field, key + ".file", nodes.data->get("file"));
    }
}

// `data`: how it reads its file, if it has one.
animation::Array make_array(const std::string& name, const ArrayNodes& nodes,
                            const TableOptions* data, Tables& tables, TrackTable& tracks) {
    animation::Array array;
    array.name = name;
    const std::string key = "arrays." + name;
    if (data) {
        add_data(nodes, key, *data, tables, tracks, array);
    } else {
        if (!nodes.count) {
            fail(*nodes.place, key,
                 "needs count, the number of elements, or file, a table of them");
        }
        array.count = read_count(*nodes.count, key + ".count");
    }
    if (nodes.count) tracks.place(name + ".count", key + ".count", nodes.count);
    for (const std::string& field : nodes.order) {
        const toml::node& node = *nodes.fields.at(field);
        const std::string field_key = key + "." + field;
        array.fields.push_back({field, read_field(node, field_key)});
        tracks.place(name + "." + field, field_key, &node);
        const auto* list = std::get_if<std::vector<double>>(&array.fields.back().source);
        if (list && nodes.data) {
            fail(node, field_key,
                 "a list beside a file: put it into the file, as a column, or write an expression");
        }
        if (list && list->size() != std::size_t(array.count)) {
            fail(node, field_key,
                 fmt::format("has {} values for {} elements; give one for each", list->size(),
                             array.count));
        }
    }
    if (array.fields.size() > std::size_t(limits::fields)) {
        fail(*nodes.place, key,
             fmt::format("has {} fields; at most {} are possible", array.fields.size(),
                         limits::fields));
    }
    return array;
}

} // namespace

std::vector<animation::Array> read_arrays(Section* catalogue, Section& document,
                                          const animation::Timeline& timeline, TrackTable& tracks,
                                          const base::Confines& within) {
    std::vector<std::string> names;
    std::map<std::string, ArrayNodes> nodes;
    for (Section* from : {catalogue, &document}) {
        auto section = from ? from->section("arrays") : std::nullopt;
        if (!section) continue;
        for (const auto& [name_key, node] : section->table()) {
            const std::string name(name_key.str()), key = section->dotted(name);
            check_name(name, node, key);
            if (!node.is_table()) fail(node, key, fmt::format("must be a table: [{}]", key));
            if (!nodes.count(name)) names.push_back(name);
            gather(*node.as_table(), key, nodes[name]);
        }
    }
    if (names.size() > std::size_t(formula::max_arrays)) {
        fail(*nodes[names.back()].place, "arrays",
             fmt::format("a scene has at most {} arrays", formula::max_arrays));
    }
    Tables tables(timeline);
    std::map<std::string, TableOptions> data;
    for (const std::string& name : names) {
        if (!nodes[name].data) continue;
        tables.add(data[name] = read_data(nodes[name], "arrays." + name, within));
    }
    std::vector<animation::Array> arrays;
    arrays.reserve(names.size());
    for (const std::string& name : names) {
        const auto file = data.find(name);
        arrays.push_back(make_array(name, nodes[name], file == data.end() ? nullptr : &file->second,
                                    tables, tracks));
    }
    return arrays;
}

} // namespace isomotion::scene
