#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 4> gimp_flip{
    combination<shape::Gimp, transfer::Flip, update::Usl, double>(Shape::gimp, Transfer::flip, Update::usl),
    combination<shape::Gimp, transfer::Flip, update::Musl, double>(Shape::gimp, Transfer::flip, Update::musl),
    combination<shape::ContiguousGimp, transfer::Flip, update::Usl, double>(Shape::cpgimp, Transfer::flip, Update::usl),
    combination<shape::ContiguousGimp, transfer::Flip, update::Musl, double>(Shape::cpgimp, Transfer::flip,
                                                                             Update::musl)};

}  // namespace cavity
