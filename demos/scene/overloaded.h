// std::visit with one lambda per alternative.
#pragma once

namespace dgd_demos {

template <typename... Callables>
struct Overloaded : Callables... {
  using Callables::operator()...;
};
template <typename... Callables>
Overloaded(Callables...) -> Overloaded<Callables...>;

}  // namespace dgd_demos
