#include "roots/judge.h"

namespace isomotion::roots {

Fault judge(const FirstRoot& root, bool hit, double t, double footprint) {
    if (root.answer == Answer::undecided) return Fault::undecided;
    if (root.answer == Answer::touching && hit && t >= double(root.touch_low) - footprint &&
        t <= double(root.touch_high) + footprint) {
        return Fault::none;
    }
    const bool is_there =
        root.answer == Answer::hit || (root.answer == Answer::touching && root.after_is_hit);
    if (!hit) return is_there ? Fault::missed : Fault::none;
    if (!is_there || t < double(root.low) - footprint) return Fault::false_hit;
    return t > double(root.high) + footprint ? Fault::wrong_root : Fault::none;
}

} // namespace isomotion::roots
