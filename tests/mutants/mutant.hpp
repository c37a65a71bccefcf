/// What the planted sources are compiled with: each place that can be mutated asks here, at run time, whether
/// its mutant is on. Operators are replaced without looking for the ends of their operands: `a < b` becomes
/// `a < mutant::Less<17>{} < b`, two operators of the same precedence, of which the first only remembers a.
#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <type_traits>
#include <utility>

namespace mutant {

/// By number of mutant: 0 nothing to do, 1 it is on, 2 note when it is reached.
extern unsigned char state[];

/// Not inlined: notes that mutant n was reached; returns whether it is on.
bool asked(int n) noexcept;
/// Notes that mutant n has no meaning for the types at hand.
void has_no_meaning(int n) noexcept;

template <int N>
constexpr bool on() noexcept {
  if (std::is_constant_evaluated()) return false;
  return state[N] != 0 && asked(N);
}

template <int N>
constexpr void meaningless() noexcept {
  if (std::is_constant_evaluated()) return;
  if (state[N] != 0) has_no_meaning(N);
}

// MUTANT_INFIX(NAME, HOOK, COUNT, FIRST, SECOND): `a HOOK NAME<N>{} HOOK b` is that without NAME, or a FIRST
// b while mutant N is on, or a SECOND b while mutant N + 1 is and COUNT is 2.
#define MUTANT_INFIX(NAME, HOOK, COUNT, FIRST, SECOND)                                           \
  template <int N>                                                                               \
  struct NAME {};                                                                                \
  template <int N, class A>                                                                      \
  struct NAME##Left {                                                                            \
    A&& a;                                                                                       \
  };                                                                                             \
  template <int N, class A>                                                                      \
  constexpr NAME##Left<N, A> operator HOOK(A&& a, NAME<N>) noexcept {                            \
    return {static_cast<A&&>(a)};                                                                \
  }                                                                                              \
  template <int N, class A, class B>                                                             \
  constexpr auto operator HOOK(NAME##Left<N, A> left, B&& b) {                                   \
    using Result = std::decay_t<decltype(static_cast<A&&>(left.a) HOOK static_cast<B&&>(b))>;    \
    if constexpr (requires { Result(static_cast<A&&>(left.a) FIRST static_cast<B&&>(b)); }) {    \
      if (on<N>()) return Result(static_cast<A&&>(left.a) FIRST static_cast<B&&>(b));            \
    } else {                                                                                     \
      meaningless<N>();                                                                          \
    }                                                                                            \
    if constexpr (COUNT == 2) {                                                                  \
      if constexpr (requires { Result(static_cast<A&&>(left.a) SECOND static_cast<B&&>(b)); }) { \
        if (on<N + 1>()) return Result(static_cast<A&&>(left.a) SECOND static_cast<B&&>(b));     \
      } else {                                                                                   \
        meaningless<N + 1>();                                                                    \
      }                                                                                          \
    }                                                                                            \
    return Result(static_cast<A&&>(left.a) HOOK static_cast<B&&>(b));                            \
  }

MUTANT_INFIX(Less, <, 2, <=, >=)
MUTANT_INFIX(LessEqual, <=, 2, <, >)
MUTANT_INFIX(Greater, >, 2, >=, <=)
MUTANT_INFIX(GreaterEqual, >=, 2, >, <)
MUTANT_INFIX(Equal, ==, 1, !=, !=)
MUTANT_INFIX(Unequal, !=, 1, ==, ==)
MUTANT_INFIX(Plus, +, 1, -, -)
MUTANT_INFIX(Minus, -, 1, +, +)
MUTANT_INFIX(Times, *, 1, +, +)
MUTANT_INFIX(Over, /, 1, *, *)
MUTANT_INFIX(Modulo, %, 1, /, /)
MUTANT_INFIX(ShiftLeft, <<, 1, >>, >>)
MUTANT_INFIX(ShiftRight, >>, 1, <<, <<)
MUTANT_INFIX(And, &, 1, |, |)
MUTANT_INFIX(Or, |, 1, &, &)
MUTANT_INFIX(Xor, ^, 1, |, |)

// `a HOOK NAME<N>{} HOOK b` with an assignment for HOOK is taken from the right: the second remembers b.
#define MUTANT_ASSIGN(NAME, HOOK, OTHER)                               \
  template <int N>                                                     \
  struct NAME {};                                                      \
  template <int N, class B>                                            \
  struct NAME##Right {                                                 \
    B&& b;                                                             \
  };                                                                   \
  template <int N, class B>                                            \
  constexpr NAME##Right<N, B> operator HOOK(NAME<N>, B&& b) noexcept { \
    return {static_cast<B&&>(b)};                                      \
  }                                                                    \
  template <int N, class A, class B>                                   \
  constexpr A& operator HOOK(A& a, NAME##Right<N, B> right) {          \
    if constexpr (requires { a OTHER static_cast<B&&>(right.b); }) {   \
      if (on<N>()) {                                                   \
        a OTHER static_cast<B&&>(right.b);                             \
        return a;                                                      \
      }                                                                \
    } else {                                                           \
      meaningless<N>();                                                \
    }                                                                  \
    a HOOK static_cast<B&&>(right.b);                                  \
    return a;                                                          \
  }

MUTANT_ASSIGN(PlusAssign, +=, -=)
MUTANT_ASSIGN(MinusAssign, -=, +=)
MUTANT_ASSIGN(TimesAssign, *=, +=)
MUTANT_ASSIGN(OverAssign, /=, *=)
MUTANT_ASSIGN(AndAssign, &=, |=)
MUTANT_ASSIGN(OrAssign, |=, &=)
MUTANT_ASSIGN(ShiftRightAssign, >>=, <<=)
MUTANT_ASSIGN(ShiftLeftAssign, <<=, >>=)

// `a | True<N>{}` and `True<N>{} | a`: a as bool, or true; `&` and False likewise; `a | Opposite<N>{}`: not
// a.
template <int N>
struct True {};
template <int N>
struct False {};
template <int N>
struct Opposite {};

template <int N, class A>
constexpr bool operator|(A&& a, True<N>) {
  return on<N>() || static_cast<bool>(a);
}
template <int N, class A>
constexpr bool operator|(True<N>, A&& a) {
  return on<N>() || static_cast<bool>(a);
}
template <int N, class A>
constexpr bool operator&(A&& a, False<N>) {
  return !on<N>() && static_cast<bool>(a);
}
template <int N, class A>
constexpr bool operator&(False<N>, A&& a) {
  return !on<N>() && static_cast<bool>(a);
}
template <int N, class A>
constexpr bool operator|(A&& a, Opposite<N>) {
  return on<N>() != static_cast<bool>(a);
}

// `Not<N>{} ->* a` for `!a`, and so on: binds less than any prefix and more than any other infix operator.
template <int N>
struct Not {};
template <int N>
struct Negative {};
template <int N>
struct Increment {};
template <int N>
struct Decrement {};

template <int N, class A>
constexpr bool operator->*(Not<N>, A&& a) {
  return on<N>() == static_cast<bool>(a);
}
template <int N, class A>
constexpr auto operator->*(Negative<N>, A&& a) {
  using Result = std::decay_t<decltype(-a)>;
  return on<N>() ? Result(a) : Result(-a);
}
/// As ++a: a, or of an atomic its value.
template <int N, class A>
constexpr decltype(auto) operator->*(Increment<N>, A& a) {
  if constexpr (requires { --a; }) {
    if (on<N>()) return --a;
  }
  return ++a;
}
template <int N, class A>
constexpr decltype(auto) operator->*(Decrement<N>, A& a) {
  if (on<N>()) return ++a;
  return --a;
}

template <int N>
constexpr bool condition(bool a) noexcept {
  return on<N>() != a;
}

template <int N>
constexpr bool flipped(bool a) noexcept {
  return on<N>() != a;
}

/// An integer and its two neighbours; a floating-point number, its double and its half.
template <int N, class T>
constexpr T number(T value) noexcept {
  if constexpr (std::is_same_v<T, bool>) {
    meaningless<N + 1>();
    return on<N>() != value;
  } else if constexpr (std::is_floating_point_v<T>) {
    if (on<N>()) return value == 0 ? T(1) : 2 * value;
    if (on<N + 1>()) return value == 0 ? T(-1) : value / 2;
    return value;
  } else if constexpr (std::is_integral_v<T>) {
    if (on<N>()) return static_cast<T>(value + 1);
    if (on<N + 1>()) return static_cast<T>(value - 1);
    return value;
  } else {
    meaningless<N>();
    meaningless<N + 1>();
    return value;
  }
}

/// The literal 0, or 1.
template <int N, class T>
constexpr T zero(T value) noexcept {
  return on<N>() ? T(1) : value;
}

template <int N, class T>
constexpr const T& least(const T& a, const T& b) {
  if (on<N>()) return std::max(a, b);
  return std::min(a, b);
}
template <int N, class T>
constexpr T least(std::initializer_list<T> all) {
  if (on<N>()) return std::max(all);
  return std::min(all);
}
template <int N, class T, class Less>
constexpr const T& least(const T& a, const T& b, Less less) {
  if (on<N>()) return std::max(a, b, less);
  return std::min(a, b, less);
}
template <int N, class T>
constexpr const T& greatest(const T& a, const T& b) {
  if (on<N>()) return std::min(a, b);
  return std::max(a, b);
}
template <int N, class T>
constexpr T greatest(std::initializer_list<T> all) {
  if (on<N>()) return std::min(all);
  return std::max(all);
}
template <int N, class T, class Less>
constexpr const T& greatest(const T& a, const T& b, Less less) {
  if (on<N>()) return std::min(a, b, less);
  return std::max(a, b, less);
}

}  // namespace mutant
