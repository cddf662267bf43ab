#pragma once

namespace airlight {

// A member of Class that is a T, such as &Class::name.
template <class Class, class T>
using MemberOf = T Class::*;

}  // namespace airlight
