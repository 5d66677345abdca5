/// \file
/// A state of packs, one lane after the other: for code that knows single numbers only.
#pragma once

#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>

namespace mote {

/// Calls f(one, l) with each lane l of a state's fields as a state of single numbers, and takes over what f makes of
/// it.
template <class V, class... Tags, class F>
void for_each_lane(V& values, fields<Tags...>, const F& f) {
  constexpr int D = V::dimension;
  for (int l = 0; l < lanes; ++l) {
    Values<Scalar<typename V::number>, D, fields<Tags...>> one;
    const auto take = [&]<class Tag>(Tag) {
      for (int i = 0; i < components_of_value<Tag, D>; ++i)
        component<Tag>(get<Tag>(one), i) = lane(component<Tag>(get<Tag>(values), i), l);
    };
    (take(Tags{}), ...);
    f(one, l);
    const auto put = [&]<class Tag>(Tag) {
      for (int i = 0; i < components_of_value<Tag, D>; ++i)
        component<Tag>(get<Tag>(values), i).set(l, component<Tag>(get<Tag>(one), i));
    };
    (put(Tags{}), ...);
  }
}

}  // namespace mote
