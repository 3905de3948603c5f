// Encloses a field over boxes at one frame, from the elements that matter there.
//
// What lists leave out of a sum is a number at each place, within bounds that the grid tells; left
// out of what may be the least element are some whose keys are not less than a number. All
// that is said of values holds for each such number. So does what is said of slopes, taken as if
// the number were the same along the box: where a slope has one sign for each of them, values
// between two places lie between those at the two. The list at a place lacks what that of a box
// around it has, which is no more than what it leaves out: so sums begin with twice the bounds.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "elements/grid_maker.h"
#include "formula/enclosure.h"

namespace isomotion::elements {

// The programs of a field, and what is made of a frame's values.
class FieldByPlace {
public:
    // Finds the elements of the largest array that a grid can be made of. None if no such array has
    // more than `few` elements: summing those takes no longer than looking them up.
    static constexpr int few = 64;
    static std::optional<FieldByPlace> of(const formula::Field& field,
                                          std::span<const int> elements_of_arrays);

    // At one frame; for all threads. This outlives it.
    class Frame {
    public:
        const formula::EnclosuresApart& programs() const { return of_->programs_; }
        const ElementGrid& grid() const { return *grid_; }
        const Region& region() const { return region_; }
        int elements() const { return elements_; }
        // A field of the array, one number an element.
        std::span<const float> column(int field) const { return columns_[std::size_t(field)]; }
        const formula::Bindings<Interval>& others() const { return others_; }
        // What a sum of a program begins with, of all that lists leave out: bounds of it, which
        // are 0 of sums in derivatives alone; of what asks for the least element, any that is not
        // less than the grid's least.
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
        formula::Bindings<Interval> others_; // parameters, and arrays of which there is no grid
    };
    int array() const { return grid_maker_.array(); }
    // `made`: a grid of these bindings over this region that is there already; null, or one of
    // another array, if there is none.
    Frame at(const formula::Bindings<float>& bindings, const Region& region, int threads,
             std::shared_ptr<const ElementGrid> made = nullptr) const;

private:
    FieldByPlace(GridMaker grid_maker, formula::EnclosuresApart programs)
        : grid_maker_(std::move(grid_maker))
        , programs_(std::move(programs)) {}

    GridMaker grid_maker_;
    formula::EnclosuresApart programs_;
};

// Runs one of a field's programs over boxes. One a thread; frame and program outlive it.
class BoxesByPlace {
public:
    BoxesByPlace(const formula::SumsApart& program, const FieldByPlace::Frame& frame);

    // As Evaluator<Interval>::points(). The first three inputs are the box. Over boxes of very many
    // elements or cells all outputs are the entire line: smaller ones tell more for less.
    void points(std::span<const std::span<const Interval>> inputs,
                std::span<const std::span<Interval>> outputs);

private:
    // Collects the elements of the box's cells; false if they are too many.
    bool look_up(const Interval& x, const Interval& y, const Interval& z);
    void add_up(std::span<const std::span<const Interval>> inputs, std::size_t box);
    Interval over_found(std::size_t sum) const;

    const formula::SumsApart& program_;
    const FieldByPlace::Frame& frame_;
    formula::Evaluator<Interval> terms_, rest_;
    std::vector<FieldByPlace::Frame::Rest> left_out_; // of each sum
    std::vector<std::uint32_t> found_, seen_;
    std::uint32_t turn_ = 0;
    std::vector<std::vector<Interval>> places_, fields_, term_values_, sums_;
};

} // namespace isomotion::elements
