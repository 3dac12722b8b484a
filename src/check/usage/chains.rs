//! What the chains of equalities say of names: that a name moves as what it equals does, and that it is a further name of a formula.

use crate::formula::symbols::Name;

use super::entry::Usage;

/// One side of a relation: the name that is all of it, if one is; and the names in it.
pub(super) type Side = (Option<Name>, Vec<Name>);

/// The name that ends a chain as a further name of the formula before it, as ℓ does in
/// `p_\varphi = \partial L/\partial\dot\varphi = mr^2\dot\varphi = \ell`, perhaps with "= const" after it.
///
/// In `mgh = \frac12 mv^2 = E` nothing has a name on the left, and in `v = \dot x = v_0` a rate gets a value: neither is a name for
/// a formula.
///
/// In `U = RI = U_0` the same quantity gets a value in one case.
pub(super) fn name_at_the_end(sides: &[Side], is_constant: bool) -> Option<Name> {
    let sides = match sides {
        [sides @ .., (None, inside)] if is_constant && inside.is_empty() => sides,
        sides => sides,
    };
    let [(Some(first), _), .., (None, formula), (Some(name), _)] = sides else { return None };
    if first.base.eq_ignore_ascii_case(&name.base) {
        return None;
    }
    let is_used = sides[..sides.len() - 1].iter().any(|(_, inside)| inside.contains(name));
    // What depends on the time explicitly has a value at one instant only, as in `x = vt = L`.
    let is_at_an_instant = formula.contains(&Name::plain("t"));
    (!is_used && !is_at_an_instant && formula.len() > 1).then(|| name.clone())
}

/// Marks the names that are equal to something that moves or contains the time.
pub(super) fn follow(statements: &[Vec<Side>], found: &mut [Usage]) {
    let named = |found: &[Usage], is_it: fn(&Usage) -> bool| {
        let names = found.iter().filter(|usage| is_it(usage)).map(|usage| usage.name.clone());
        names.chain([Name::plain("t")]).collect::<Vec<Name>>()
    };
    let dotted = named(found, |usage| usage.moves);
    loop {
        let moving = named(found, |usage| usage.moves || usage.follows);
        let mut more = Vec::new();
        for sides in statements {
            let contains = |names: &[Name]| {
                sides.iter().any(|(alone, inside)| alone.is_none() && inside.iter().any(|name| names.contains(name)))
            };
            // On the right a constant may stand, as of a conserved quantity.
            let (on_the_left, on_the_right) = (contains(&moving), contains(&dotted));
            let alone = sides.iter().enumerate().filter(|(at, _)| if *at == 0 { on_the_left } else { on_the_right });
            let alone = alone.filter_map(|(_, (alone, _))| alone.as_ref());
            more.extend(alone.filter(|name| !moving.contains(name)).cloned());
        }
        if more.is_empty() {
            return;
        }
        for usage in found.iter_mut().filter(|usage| more.contains(&usage.name)) {
            usage.follows = true;
        }
    }
}
