// Encloses a field over boxes at one frame, from the elements that matter there.
//
// The part that lists leave out of a sum is a number at each place, within bounds that the grid
// states. Elements left out of a `least` have keys of at least a number that the grid states. All
// statements on values hold for each such number. Statements on slopes treat the number as constant
// along the box: if a slope has one sign for each such number, values between two places lie
// between those at the two. The list at a place lacks some elements that the list of a surrounding
// box has, but no more than a list leaves out; so sums begin with twice the bounds.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "elements/grid_maker.h"
#include "formula/enclosure.h"

namespace isomotion::elements {

// The programs of a field, and the data made from a frame's values.
class FieldByPlace {
public:
    // Selects the largest array that a grid can be made for. None if no such array has more than
    // `few` elements, which are summed as fast as they are looked up.
    static constexpr int few = 64;
    static std::optional<FieldByPlace> of(const formula::Field& field,
                                          std::span<const int> elements_of_arrays);

    // The field at one frame, for all threads. The FieldByPlace must outlive it.
    class Frame {
    public:
        const formula::EnclosuresApart& programs() const { return of_->programs_; }
        const ElementGrid& grid() const { return *grid_; }
        const Region& region() const { return region_; }
        int elements() const { return elements_; }
        // A field of the array, one number per element.
        std::span<const float> column(int field) const { return columns_[std::size_t(field)]; }
        const formula::Bindings<Interval>& others() const { return others_; }
        // The initial value of a program's sum, for all elements that lists leave out: bounds of
        // their sum, which are 0 for sums in derivatives alone; for a `least`, any number of at
        // least the grid's least.
        struct Rest {
            Interval sum, least;
        };
        Rest rest(const formula::SumsApart::Sum& sum) const;

    private:
        friend class FieldByPlace;
        const FieldByPlace* of_ = nullptr;
        std::shared_ptr<const ElementGrid> grid_;
        Region region_;
        int elements_ = 0;
        std::vector<std::vector<float>> columns_;
        formula::Bindings<Interval> others_; // parameters, and arrays without a grid
    };
    int array() const { return grid_maker_.array(); }
    // `made`: an existing grid of these bindings over this region; null, or a grid of another
    // array, if there is none.
    Frame at(const formula::Bindings<float>& bindings, const Region& region, int threads,
             std::shared_ptr<const ElementGrid> made = nullptr) const;

private:
    FieldByPlace(GridMaker grid_maker, formula::EnclosuresApart programs)
        : grid_maker_(std::move(grid_maker))
        , programs_(std::move(programs)) {}

    GridMaker grid_maker_;
    formula::EnclosuresApart programs_;
};

// Runs one of a field's programs over boxes. Use one per thread. Frame and program must outlive it.
class BoxesByPlace {
public:
    BoxesByPlace(const formula::SumsApart& program, const FieldByPlace::Frame& frame);

    // Evaluates like Evaluator<Interval>::points(). The first three inputs are the box. For boxes
    // with too many elements or cells all outputs are the entire line, since smaller boxes give
    // more for less work.
    void points(std::span<const std::span<const Interval>> inputs,
                std::span<const std::span<Interval>> outputs);

private:
    // Collects the elements of the box's cells. Returns false if there are too many.
    bool look_up(const Interval& x, const Interval& y, const Interval& z);
    void add_up(std::span<const std::span<const Interval>> inputs, std::size_t box);
    Interval over_found(std::size_t sum) const;

    const formula::SumsApart& program_;
    const FieldByPlace::Frame& frame_;
    formula::Evaluator<Interval> terms_, rest_;
    std::vector<FieldByPlace::Frame::Rest> left_out_; // for each sum
    std::vector<std::uint32_t> found_, seen_;
    std::uint32_t turn_ = 0;
    std::vector<std::vector<Interval>> places_, fields_, term_values_, sums_;
};

} // namespace isomotion::elements
