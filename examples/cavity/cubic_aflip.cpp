#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 2> cubic_aflip{
    combination<shape::CubicBSpline, transfer::AffineFlip, update::Usl, double>(Shape::cubic, Transfer::aflip,
                                                                                Update::usl),
    combination<shape::CubicBSpline, transfer::AffineFlip, update::Musl, double>(Shape::cubic, Transfer::aflip,
                                                                                 Update::musl)};

}  // namespace cavity
