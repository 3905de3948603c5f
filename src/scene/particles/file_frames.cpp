#include "scene/particles/file_frames.h"

#include <algorithm>
#include <semaphore>
#include <span>
#include <system_error>

#include <fmt/format.h>

#include "base/content_hash.h"
#include "base/file.h"
#include "base/file_stamp.h"
#include "base/regular_file.h"
#include "scene/error.h"
#include "scene/limits.h"
#include "scene/particles/column_choice.h"
#include "scene/particles/read_particles.h"

namespace isomotion::scene {
namespace {

// Files that are read at the same time, of all arrays: each may have hundreds of megabytes
// unpacked.
constexpr int read_together = 2;
std::counting_semaphore<read_together> free_to_read(read_together);

class OneOfFew {
public:
    OneOfFew() { free_to_read.acquire(); }
    ~OneOfFew() { free_to_read.release(); }
    OneOfFew(const OneOfFew&) = delete;
    OneOfFew& operator=(const OneOfFew&) = delete;
};

constexpr std::size_t most_kept = 6, fewest_kept = 3, ahead = 2;
constexpr std::size_t bytes_kept = 256 << 20;
constexpr std::uintmax_t bytes_hashed = 1 << 30;

// A file's bytes, or those at both its ends.
void add_file(base::ContentHash& hash, base::RegularFile file, bool whole) {
    std::vector<std::byte> piece(whole ? 1 << 20 : 1 << 16);
    const auto add = [&] {
        const std::size_t count = file.read(piece);
        hash.add(std::span<const std::byte>(piece).first(count));
        return count == piece.size();
    };
    if (whole) {
        while (add())
            ;
    } else if (add()) {
        file.go_to(file.size() - std::min(file.size(), piece.size()));
        add();
    }
}

} // namespace

FileFrames::FileFrames(FrameFiles files)
    : files_(std::move(files))
    , wanted_(files_.columns.size()) {
    for (const std::filesystem::path& file : files_.files) stamps_.push_back(base::stamp_of(file));
}

FileFrames::~FileFrames() = default; // waits for what is being read ahead

// Frames of two simulations would pass for those of one: the fingerprint of all is one.
void FileFrames::expect_unchanged(std::size_t k) const {
    if (base::stamp_of(files_.files[k]) == stamps_[k]) return;
    ParticleRequest of;
    of.file = files_.files[k];
    fail_of_file(of, "changed after the scene was read; start again when nothing writes it any "
                     "more");
}

void FileFrames::expect_unchanged() const {
    for (std::size_t k = 0; k < files_.files.size(); ++k) expect_unchanged(k);
}

std::size_t FileFrames::frames_kept() const {
    const auto columns = std::size_t(std::ranges::count(wanted_, true)) + 1;
    return std::clamp(bytes_kept / (8 * columns * std::max<std::size_t>(files_.most, 1)),
                      fewest_kept, most_kept);
}

std::size_t FileFrames::frames_now() const {
    const std::lock_guard lock(mutex_);
    return entries_.size();
}

std::size_t FileFrames::files_read() const {
    const std::lock_guard lock(mutex_);
    return files_read_;
}

FileFrames::FramePointer FileFrames::read(std::size_t k, const std::vector<bool>& columns) const {
    const OneOfFew reading;
    ParticleRequest request;
    request.file = files_.files[k];
    request.within = files_.within;
    std::vector<std::optional<std::size_t>> from(files_.columns.size());
    std::optional<std::size_t> id;
    request.choose = [&](const std::string&, const std::vector<std::string>& names) {
        Wanted wanted{std::vector<bool>(names.size()), files_.most, limits::table_values};
        for (std::size_t c = 0; c < from.size(); ++c) {
            if (!columns[c]) continue;
            from[c] = find_column(names, files_.columns[c]);
            if (!from[c]) {
                throw NamedColumn{files_.columns[c],
                                  fmt::format("there is no such column; {} has it",
                                              files_.files[0].filename().string())};
            }
            wanted.columns[*from[c]] = true;
        }
        id = find_column(names, "id");
        if (id) wanted.columns[*id] = true;
        return wanted;
    };
    ParticleTable table = read_particles(request, limits::table_bytes).table;
    expect_unchanged(k);
    if (table.count > files_.most) {
        fail_of_file(request, fmt::format("holds {} particles; the array's count allows {}",
                                          table.count, files_.most));
    }
    const auto frame = std::make_shared<Frame>();
    frame->format = table.format;
    frame->count = table.count;
    frame->columns.resize(from.size());
    if (table.count == 0) return frame;
    if (id) {
        // The ids may be a field as well; that is copied before they are taken.
        std::vector<double> as_field;
        for (std::size_t c = 0; c < from.size(); ++c) {
            if (from[c] != id) continue;
            if (as_field.empty()) {
                as_field = take_numbers(table, request.file, *id);
                if (auto* text = std::get_if<std::vector<double>>(&table.columns[*id].values))
                    *text = as_field;
            }
            frame->columns[c] = as_field;
            from[c].reset();
        }
        frame->ids = take_whole_numbers(table, request.file, *id);
        if (const auto twins = animation::find_twins(frame->ids)) {
            throw SceneError(fmt::format("{}: id: {} is that of particle {} already",
                                         place(table, request.file, *id, twins->second),
                                         frame->ids[twins->first], twins->first + 1));
        }
    }
    for (std::size_t c = 0; c < from.size(); ++c) {
        const auto& column = from[c];
        if (!column) continue;
        const auto before = std::find(from.begin(), from.begin() + std::ptrdiff_t(c), column);
        frame->columns[c] = before == from.begin() + std::ptrdiff_t(c)
                                ? take_numbers(table, request.file, *column)
                                : frame->columns[std::size_t(before - from.begin())];
    }
    return frame;
}

FileFrames::Entry* FileFrames::find(std::size_t k) const {
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
        if (entry->frame != k) continue;
        entries_.splice(entries_.begin(), entries_, entry);
        return &entries_.front();
    }
    return nullptr;
}

// Makes room for one more, but keeps what is about frame k. Says whether there is room.
bool FileFrames::make_room(std::size_t k) const {
    for (auto entry = entries_.end();
         entries_.size() >= frames_kept() && entry != entries_.begin();) {
        --entry;
        const bool is_near = entry->frame + 1 >= k && entry->frame <= k + ahead;
        if (!is_near) entry = entries_.erase(entry);
    }
    return entries_.size() < frames_kept();
}

void FileFrames::read_ahead(std::size_t k) const {
    for (std::size_t next = k + 1; next <= k + ahead && next < files_.files.size(); ++next) {
        if (std::ranges::any_of(entries_, [&](const Entry& e) { return e.frame == next; }))
            continue;
        if (!make_room(k)) return;
        try {
            entries_.push_back(
                {next, wanted_, std::async(std::launch::async, [this, next, columns = wanted_] {
                                    return read(next, columns);
                                }).share()});
            ++files_read_;
        } catch (const std::system_error&) { // no thread is to be had: it is read when asked for
            return;
        }
    }
}

FileFrames::FramePointer FileFrames::frame(std::size_t k, const std::vector<bool>& columns) const {
    std::shared_future<FramePointer> future;
    std::packaged_task<FramePointer()> task;
    {
        const std::lock_guard lock(mutex_);
        for (std::size_t c = 0; c < columns.size(); ++c) wanted_[c] = wanted_[c] || columns[c];
        Entry* entry = find(k);
        const auto lacks = [&](const Entry& known) {
            for (std::size_t c = 0; c < columns.size(); ++c) {
                if (columns[c] && !known.columns[c]) return true;
            }
            return false;
        };
        if (entry && lacks(*entry)) {
            entries_.pop_front();
            entry = nullptr;
        }
        if (!entry) {
            task = std::packaged_task<FramePointer()>(
                [this, k, all = wanted_] { return read(k, all); });
            if (!make_room(k)) entries_.pop_back();
            entries_.push_front({k, wanted_, task.get_future().share()});
            ++files_read_;
        }
        future = entries_.front().read;
        const bool follows = k == asked_ + 1;
        asked_ = k;
        if (follows) read_ahead(k);
    }
    if (task.valid()) task();
    try {
        return future.get();
    } catch (...) { // it may be there the next time
        const std::lock_guard lock(mutex_);
        std::erase_if(entries_, [&](const Entry& entry) { return entry.frame == k; });
        throw;
    }
}

animation::SampleSource::Sample FileFrames::sample(std::size_t k,
                                                   const std::vector<bool>& columns) const {
    const FramePointer here = frame(k, columns);
    Sample sample{here->count, {}, here};
    sample.columns.resize(columns.size());
    for (std::size_t c = 0; c < columns.size(); ++c) {
        if (columns[c]) sample.columns[c] = here->columns[c];
    }
    return sample;
}

animation::SampleSource::Successors FileFrames::successors(std::size_t k) const {
    const std::vector<bool> none(files_.columns.size());
    const FramePointer here = frame(k, none), there = frame(k + 1, none);
    if (here->ids.empty() || there->ids.empty()) {
        // One that has none left has none of the ids either.
        return Successors(std::min(here->count, there->count));
    }
    {
        const std::lock_guard lock(mutex_);
        if (matched_.rows && matched_.frame == k) return {*matched_.rows, matched_.rows};
    }
    const auto rows =
        std::make_shared<const std::vector<std::uint32_t>>(animation::match(here->ids, there->ids));
    const std::lock_guard lock(mutex_);
    matched_ = {k, rows};
    return {*rows, rows};
}

void FileFrames::add_column(base::Fingerprint& print, std::size_t column) const {
    print.add(files_.columns[column]);
}

void FileFrames::add_rows(base::Fingerprint& print) const {
    const std::lock_guard lock(mutex_);
    if (print_.empty()) {
        std::vector<std::uintmax_t> sizes;
        for (const std::filesystem::path& file : files_.files) {
            std::error_code ignored;
            const std::uintmax_t size = std::filesystem::file_size(file, ignored);
            sizes.push_back(ignored ? 0 : size);
        }
        std::uintmax_t all = 0;
        for (const std::uintmax_t size : sizes) all += size;
        base::ContentHash hash;
        hash.add_values(std::span<const std::uintmax_t>(sizes));
        for (const std::filesystem::path& file : files_.files) {
            try {
                add_file(hash, base::RegularFile(file, files_.within), all <= bytes_hashed);
            } catch (const base::FileError&) { // gone: told when its frame is asked for
            }
        }
        print_ = hash.text();
    }
    print.add_values(std::span(files_.times)).add(print_);
}

std::string FileFrames::origin(std::size_t k) const {
    const FramePointer here = frame(k, std::vector<bool>(files_.columns.size()));
    return fmt::format("{}: {}; {} files, {} to {}", files_.files[k].string(), here->format,
                       files_.files.size(), files_.files.front().filename().string(),
                       files_.files.back().filename().string());
}

} // namespace isomotion::scene
