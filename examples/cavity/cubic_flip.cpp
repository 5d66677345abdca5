#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 2> cubic_flip{
    combination<shape::CubicBSpline, transfer::Flip, update::Usl, double>(Shape::cubic, Transfer::flip, Update::usl),
    combination<shape::CubicBSpline, transfer::Flip, update::Musl, double>(Shape::cubic, Transfer::flip, Update::musl)};

}  // namespace cavity
