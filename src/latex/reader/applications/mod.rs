//! A name directly before a parenthesis: a function with its argument, or a product.
//!
//! In print both look alike, so the contents of the parenthesis decide:
//!
//! | contents | reading |
//! | --- | --- |
//! | the time after a symbol that varies, or the declared argument | the symbol itself |
//! | a list of the coordinates, velocities and momenta of the motion: `H(q, p)` | the symbol itself |
//! | one of the names in the formula that defines the symbol: `V(x)` | the symbol itself |
//! | a lone name or a number, with a power, after a declared constant | a product, `m (r)^2` |
//! | else a lone name, a number, a list | rejected: `f(x)`, `x(0)`, `H(q, p)` |
//! | the time in a sum, after a symbol that varies or is not declared | rejected: `x(t + T)` |
//! | a sum | a product, `m(a + b)` |
//! | one term | a product after a declared name |
//!
//! Without declarations, one term is a product only with a dotted symbol in it, `\lambda(\dot\phi \sin\theta)`, or with a
//! power on the parenthesis, `m(l\omega)^2`. The usual names of functions, and names with a prime, are rejected before
//! any parenthesis.
//!
//! Offers `applied` and `is_no_value`, methods of the reader. Knows the layout, the names and the state of the reader.

mod factors;
mod inside;
mod values;

use crate::formula::SymbolId;
use crate::formula::symbols::{Entry, Kind, Name};
use crate::formula::tree::Expr;
use crate::source::{Fault, Span};

use super::super::arguments::{goes_on_with_a_parenthesis, has_dagger};
use super::super::layout::{Delimiter, Item, Layout};
use super::super::names;
use super::items::{differential, function_head, is_lone, is_minus_one};
use super::state::{Read, Reader};
pub(super) use inside::are_names;
use inside::{
    FIELDS, has_nabla, has_rate, is_fractional, is_function, is_product_of_vectors, is_special_function,
    is_step_function, is_value, is_zero, may_be_a_number, may_be_an_argument, may_be_an_index, may_contain_itself,
    mentions, parenthesis, relation_or_comma,
};

impl Reader<'_> {
    /// A symbol with its power. A parenthesis after it is a separate factor, unless it may be a function's argument.
    pub(super) fn applied(
        &mut self,
        expr: Expr,
        id: SymbolId,
        sup: Option<&Item>,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Expr> {
        let span = expr.span;
        // `\psi^* (T + V) \psi`
        if self.is_abstract() && sup.is_some() && self.is_between_states(id, items, *cursor) {
            return match sup {
                Some(sup) => self.raised(expr, sup, span),
                None => Ok(expr),
            };
        }
        if self.is_abstract()
            && let Some(found) = self.applied_as_printed(&expr, id, sup, items, cursor)?
        {
            return Ok(found);
        }
        if let Some(value) = self.at_a_time((&expr, id), sup, items, cursor)? {
            return Ok(value);
        }
        match items.get(*cursor) {
            // `x(t)^2` is the square of x.
            Some(Item { layout: Layout::Scripts { nucleus, sub: None, sup: Some(above), primes: 0 }, .. })
                if sup.is_none() && self.is_argument(nucleus, id) =>
            {
                *cursor += 1;
                return self.raised(expr, above, span);
            }
            Some(next) if self.is_argument(next, id) => *cursor += 1,
            Some(next) if sup.is_some() && self.is_before_a_quotient(id, sup, next) => {}
            Some(next) => match self.is_a_product(id, span, next) {
                // `V(1/u)` is shown as it is printed: nobody puts a single factor of a product in parentheses. A letter that
                // is no usual name of a function is refused, as in `ie(\partial_\mu A_\nu)`.
                Err(_)
                    if self.is_abstract()
                        && (sup.is_none() || sup.is_some_and(is_minus_one) && self.is_transform(id, next))
                        && !may_be_a_number(&self.symbols.entry(id).name, next)
                        && !goes_on_with_a_parenthesis(&items[*cursor..])
                        && self.is_applied(id, next) =>
                {
                    // The brackets are those of the template.
                    let argument = match &next.layout {
                        Layout::Fence(Delimiter::Square | Delimiter::Curly, inside) => self.sum(inside, next.span)?,
                        _ => self.item(next)?,
                    };
                    *cursor += 1;
                    let whole = span.to(next.span);
                    let template = match &next.layout {
                        Layout::Fence(Delimiter::Curly, _) if sup.is_some() => "#^{-1}\\{#\\}",
                        Layout::Fence(_, _) if sup.is_some() => "#^{-1}[#]",
                        Layout::Fence(Delimiter::Curly, _) => "#\\{#\\}",
                        Layout::Fence(Delimiter::Square, _) => "#[#]",
                        _ => "#(#)",
                    };
                    self.is_shown_as_a_function(id);
                    return Ok(self.template(template, vec![expr, argument], whole));
                }
                found => found?,
            },
            None => {}
        }
        match sup {
            Some(sup) => self.raised(expr, sup, span),
            None => Ok(expr),
        }
    }

    /// In a display that is read for its structure: a name before a lone name, a 0 or a list in parentheses is shown with
    /// its arguments, and a power before a product in parentheses is no function.
    fn applied_as_printed(
        &mut self,
        expr: &Expr,
        id: SymbolId,
        sup: Option<&Item>,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Option<Expr>> {
        let Some((fence, inside)) = items.get(*cursor).and_then(parenthesis) else { return Ok(None) };
        if self.symbols.open && self.is_a_product_by_its_power(id, &items[*cursor]) {
            return Ok(None);
        }
        if let Some(found) = self.at_an_instant(expr, sup, fence, cursor)? {
            return Ok(Some(found));
        }
        if let Some(found) = self.of_an_event(expr, id, sup, fence, cursor)? {
            return Ok(Some(found));
        }
        let is_comma = |item: &&Item| matches!(item.layout, Layout::Other(',' | ';'));
        // `y = k(0) + c` puts in a number.
        let is_constant = ["k", "c", "b", "l"].contains(&self.symbols.entry(id).name.base.as_str());
        let is_place = |item: &&Item| self.lone_name(item).is_some() || is_comma(item) || is_zero(item) && !is_constant;
        let is_list = inside.len() == 1 || inside.iter().any(is_comma);
        let entry = self.symbols.entry(id);
        // `y[p_z, z]` has a commutator in it.
        let is_pair = !matches!(fence.layout, Layout::Fence(Delimiter::Round, _)) && inside.iter().any(is_comma);
        let is_plain = ["\\pi", "\\hbar", "e", "d"].contains(&entry.name.base.as_str());
        let is_call =
            is_list && inside.iter().all(is_place) && matches!(fence.layout, Layout::Fence(Delimiter::Round, _));
        let is_vector = entry.kind == Kind::Vector || entry.kind == Kind::Abstract;
        let has_operator = inside.iter().any(|item| {
            matches!(&item.layout, Layout::Command(name) if ["\\nabla", "\\cdot", "\\times", "\\wedge"].contains(&name.as_str()))
        });
        // `k_1[E]`: a concentration after a constant; `S[q]` is a functional.
        let is_bracketed = matches!(fence.layout, Layout::Fence(Delimiter::Square, _))
            && matches!(inside.as_slice(), [only] if self.lone_name(only).is_some())
            && !is_function(entry)
            && entry.name.base.chars().all(char::is_lowercase);
        // `\Delta^{\nu\beta}(a + b)`: a letter with two indices is no function.
        let has_indices = sup.is_some_and(|sup| self.is_index_of_several(sup)) && inside.len() > 1;
        let is_product = is_pair
            || has_indices
            || is_bracketed
            || sup.is_some_and(super::items::is_transpose) && !is_call
            || sup.is_some() && !is_function(entry) && inside.len() > 1 && !self.shifts_the_time(&inside)
            || is_vector && has_operator;
        // `\gamma(c, v)`: a factor of components. `m(\ddot x)`: an acceleration is no argument.
        let is_factor = entry.name.base == "\\gamma" && inside.iter().any(is_comma)
            || matches!(inside.as_slice(), [only] if self.lone_name(only).is_some_and(|(_, dots)| dots > 1));
        let named = match sup {
            _ if is_factor && !is_product => return Ok(None),
            _ if is_plain || !is_call && !is_product => return Ok(None),
            Some(sup) => self.raised(expr.clone(), sup, expr.span)?,
            None => expr.clone(),
        };
        if is_product {
            return Ok(Some(named));
        }
        let Layout::Fence(_, given) = &fence.layout else { return Ok(None) };
        let span = expr.span.to(fence.span);
        let mut arguments = vec![named];
        for argument in given.split(|item| matches!(item.layout, Layout::Other(',' | ';'))) {
            arguments.push(self.sum(argument, span)?);
        }
        let holes = vec!["#"; arguments.len() - 1].join(", ");
        let applied = self.template(&format!("#({holes})"), arguments, span);
        *cursor += 1;
        match &items[*cursor - 1].layout {
            Layout::Scripts { sup: Some(above), .. } => self.raised(applied, above, span).map(Some),
            _ => Ok(Some(applied)),
        }
    }

    /// Takes a name out of the real numbers, since it stands before its argument.
    fn is_shown_as_a_function(&mut self, id: SymbolId) {
        let entry = self.symbols.entry_mut(id);
        if entry.kind == Kind::Scalar {
            entry.kind = Kind::Abstract;
        }
    }

    /// Whether a name that usually stands for a function has a parenthesis after it, without a script, that holds one term.
    fn is_applied(&self, id: SymbolId, next: &Item) -> bool {
        let Layout::Fence(delimiter, inside) = &next.layout else { return false };
        let entry = self.symbols.entry(id);
        if self.is_transform(id, next) && !inside.iter().any(relation_or_comma) {
            return !inside.is_empty();
        }
        if *delimiter != Delimiter::Round {
            return false;
        }
        if is_step_function(entry, inside) {
            return true;
        }
        // `ru(1 - u)`: nothing is a function of itself.
        if !may_contain_itself(entry) && inside.iter().any(|item| mentions(item, &entry.name)) {
            return false;
        }
        let is_usual = is_function(entry)
            || FIELDS.contains(&entry.name.base.as_str()) && entry.name.subscript != ["0"]
            || self.is_inferred_function(&entry.name)
            || super::structure::is_function_letter(&entry.name, inside);
        let is_term = !inside.iter().skip(1).any(|item| self.is_sign(item) || relation_or_comma(item));
        // `w (\partial_c X) T`: a derivative in parentheses is a factor.
        let is_derivative = inside.first().is_some_and(|first| {
            let nucleus = if let Layout::Scripts { nucleus, .. } = &first.layout { nucleus } else { first };
            nucleus.layout == Layout::Command("\\partial".to_owned())
        });
        is_usual
            && !self.symbols.inferred.factors.contains(&entry.name)
            && !is_derivative
            && is_term
            && !inside.is_empty()
            && !has_nabla(inside)
            && !has_dagger(inside)
            && self.is_argument_by_its_letters(entry, inside)
    }

    /// `\mathcal{F}\{f(x)\}`, `\mathcal{L}[f]`: a transform, whatever stands in it.
    fn is_transform(&self, id: SymbolId, next: &Item) -> bool {
        let base = &self.symbols.entry(id).name.base;
        matches!(next.layout, Layout::Fence(Delimiter::Curly | Delimiter::Square, _))
            && ["\\mathcal{", "\\mathscr{", "\\mathfrak{"].iter().any(|style| base.starts_with(style))
    }

    /// Whether one term in a parenthesis is more likely an argument than a factor: not a product of letters of which none is a place, a
    /// time or the like, and no number before a sum, `u(2(a + b))`. Of f nobody makes a product.
    fn is_argument_by_its_letters(&self, entry: &Entry, inside: &[Item]) -> bool {
        const USUAL: [&str; 18] = [
            "x", "y", "z", "r", "t", "q", "s", "p", "k", "E", "T", "\\omega", "\\tau", "\\theta", "\\phi", "\\varphi",
            "\\rho", "\\xi",
        ];
        let letters: Vec<Name> =
            inside.iter().filter_map(|item| names::printed(item, self.branch)).map(|found| found.name).collect();
        let is_bare = |base: &str| USUAL.iter().any(|usual| base == *usual || base.ends_with(&format!("{{{usual}}}")));
        let has_usual = letters.iter().any(|name| is_bare(&name.base) && name.subscript.is_empty());
        let has_sum = inside.iter().any(|item| {
            matches!(&item.layout, Layout::Fence(_, inner) if inner.iter().skip(1).any(|item| self.is_sign(item)))
        });
        let is_sure = entry.name.base == "f" || self.is_inferred_function(&entry.name);
        is_sure || !(has_sum && inside.len() > 1) && (letters.len() < 2 || has_usual)
    }

    /// Whether a parenthesis is the argument of a symbol and no factor: the time, or the declared argument.
    fn is_argument(&self, item: &Item, id: SymbolId) -> bool {
        let entry = self.symbols.entry(id);
        self.is_time_in_parentheses(item) && entry.varies
            || entry.argument.as_ref().is_some_and(|argument| is_lone(item, argument))
            || self.is_a_coordinate_by_another(item, id)
            || self.are_what_it_depends_on(item, id)
    }

    /// Whether the names in parentheses are what a symbol depends on, so that it stands for its value there. A list cannot be
    /// a factor, and nobody multiplies a name by one from its own formula in this way: `V(x)` after V = k x²/2.
    ///
    /// In a list each kind of variable has the order of the coordinates. With K = x² y, K(y, x) may be another value of K.
    fn are_what_it_depends_on(&self, item: &Item, id: SymbolId) -> bool {
        let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
        let entry = self.symbols.entry(id);
        let own = self.symbols.variables_of(id);
        if self.symbols.open || !entry.arguments.is_empty() || own.is_empty() && !entry.derived {
            return false;
        }
        let is_comma = |item: &Item| matches!(item.layout, Layout::Other(',' | ';'));
        let mut given: Vec<(SymbolId, u8)> = Vec::new();
        let mut has_time = false;
        let arguments: Vec<&[Item]> = inside.split(is_comma).collect();
        for argument in &arguments {
            let mut names = argument.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
            let (Some(only), None) = (names.next(), names.next()) else { return false };
            let Some((name, dots)) = self.lone_name(only) else { return false };
            if Some(&name) == self.symbols.time.as_ref() && dots == 0 && !has_time {
                has_time = true;
                continue;
            }
            match self.symbols.find(&name) {
                Some((other, indices)) if indices.is_empty() && other != id => given.push((other, dots)),
                _ => return false,
            }
        }
        // The effective potential and the energy are functions of the coordinates, though no formula of them is known here.
        let is_of_the_motion = |(other, dots): &(SymbolId, u8)| {
            let is_coordinate = self.symbols.canonical.iter().any(|(q, _)| q == other);
            entry.derived && !entry.momentum && own.is_empty() && is_coordinate && *dots == 0
        };
        let depends = |given: &(SymbolId, u8)| own.contains(given) || is_of_the_motion(given);
        if let ([only], 1) = (given.as_slice(), arguments.len()) {
            return depends(only) && self.symbols.entry(only.0).varies;
        }
        let place = |(other, dots): &(SymbolId, u8)| {
            let is_momentum = |names: &[SymbolId]| *dots == 0 && names.contains(other);
            let of = |(q, names): &(SymbolId, Vec<SymbolId>)| q == other && *dots <= 1 || is_momentum(names);
            let at = self.symbols.canonical.iter().position(of)?;
            let kind = if self.symbols.canonical[at].0 == *other { *dots } else { 2 };
            Some((kind, at))
        };
        let Some(places) = given.iter().map(place).collect::<Option<Vec<(u8, usize)>>>() else { return false };
        let in_order = |kind: u8| {
            let of_kind: Vec<usize> = places.iter().filter(|place| place.0 == kind).map(|place| place.1).collect();
            of_kind.is_sorted_by(|a, b| a < b)
        };
        (entry.derived || given.iter().any(depends)) && (0..=2).all(in_order)
    }

    /// Whether one coordinate stands in parentheses after another: `r(\phi)` is an orbit, and nobody writes a product so.
    fn is_a_coordinate_by_another(&self, item: &Item, id: SymbolId) -> bool {
        let Layout::Fence(Delimiter::Round, _) = &item.layout else { return false };
        let Some((_, inside)) = parenthesis(item) else { return false };
        let [only] = inside.as_slice() else { return false };
        let Some((name, 0)) = self.lone_name(only) else { return false };
        let is_coordinate = |id: SymbolId| {
            let entry = self.symbols.entry(id);
            let is_free = entry.definition.is_none() && !entry.derived && !entry.momentum && entry.operator.is_none();
            entry.varies && is_free && entry.arguments.is_empty() && Some(&entry.name) != self.symbols.time.as_ref()
        };
        let other = self.symbols.find(&name).map(|(other, _)| other);
        !self.symbols.open && other.is_some_and(|other| other != id && is_coordinate(other)) && is_coordinate(id)
    }

    /// Rejects what follows a symbol if it is a parenthesis that may be the argument of a function.
    fn is_a_product(&self, id: SymbolId, span: Span, next: &Item) -> Read<()> {
        let Some((fence, inside)) = parenthesis(next) else { return Ok(()) };
        let entry = self.symbols.entry(id);
        let name = &entry.name;
        let is_product = self.is_a_product_by_its_brackets(id, fence) || self.is_a_product_by_its_power(id, next);
        if self.symbols.open && is_product {
            return Ok(());
        }
        // ħ is no function.
        if self.symbols.open && name.base == "\\hbar" && !inside.iter().any(|item| relation_or_comma(item)) {
            return Ok(());
        }
        let is_powered = !matches!(next.layout, Layout::Fence(..));
        // What does not vary is no function of anything: `m (r_\perp)^2`.
        let is_factor = is_powered && !self.symbols.open && (!entry.varies || entry.steady) && !is_function(entry);
        if !is_factor {
            self.is_no_value(&name.to_string(), span, next)?;
        }
        let span = span.to(fence.span);
        let ambiguous = || {
            let fault = Fault::ambiguous(span, format!("{name}(…) may be a function or a product")).help(
                "for a product, put a thin space \\, before the parenthesis; \
                 for a function, declare it under \"functions\" in a claims file",
            );
            Err(may_be_an_index(name, &self.bound, span).unwrap_or(fault))
        };
        // `x(-\cos x)`: nothing is a function of itself. A differential stands in no argument, `p(c\,dt)`.
        let has_itself = inside.iter().any(|item| mentions(item, name)) && name.primes == 0;
        let has_differential = self.symbols.infers()
            && self.symbols.inferred.differentials
            && inside
                .windows(2)
                .any(|pair| differential(pair[0]) == Some(1) && names::printed(pair[1], None).is_some());
        let is_factor = !is_function(entry) && !FIELDS.contains(&name.base.as_str());
        let is_logistic = has_itself && !may_contain_itself(entry);
        if self.symbols.open && (is_logistic || is_factor && has_differential) {
            return Ok(());
        }
        // The Lorentz factor is no function of the place or the time.
        let is_lorentz =
            self.symbols.open && name.base == "\\gamma" && inside.iter().skip(1).any(|item| self.is_sign(item));
        if is_lorentz {
            return Ok(());
        }
        if self.symbols.open && self.is_a_product_by_its_kind(id, &inside, is_powered) {
            return Ok(());
        }
        if self.symbols.open && self.is_before_a_sum_of_vectors(id, &inside) {
            return ambiguous();
        }
        if self.shifts_the_time(&inside) && (entry.varies && !entry.steady || self.symbols.open) {
            return ambiguous();
        }
        if self.symbols.guessed && is_special_function(name, &inside) {
            return ambiguous();
        }
        if self.symbols.guessed && may_be_an_argument(entry, &inside, is_powered) {
            return ambiguous();
        }
        if !self.symbols.open {
            return Ok(());
        }
        let has_sign = |items: &[Item]| items.iter().skip(1).any(|item| self.is_sign(item));
        // `mgl\left(\frac{a + b}{2}\right)` too.
        let is_sum = inside.iter().skip(1).any(|item| self.is_sign(item))
            || matches!(inside.as_slice(), [Item { layout: Layout::Fraction(above, _), .. }] if has_sign(crate::latex::layout::contents(above)));
        let is_plain_product =
            is_sum || is_powered || inside.iter().any(|item| has_rate(item)) || is_product_of_vectors(&inside);
        if has_nabla(inside.iter().copied()) {
            return Ok(());
        }
        // `U_0(1 - x/a)`, `V_0(x - a)^2`: a value, and no function of a number.
        let terms: Vec<&[&Item]> = inside.split(|item| self.is_sign(item)).collect();
        let has_number = terms.iter().any(|term| matches!(term, [Item { layout: Layout::Number(_), .. }]));
        // So are `P_0(V - V_0)`, but not a Bessel function.
        let is_bessel = ["J", "Y", "K", "I", "N"].contains(&name.base.as_str());
        let is_sum_here = !is_bessel && terms.len() > 1;
        if name.subscript == ["0"] && name.primes == 0 && inside.len() > 1 && (has_number || is_powered || is_sum_here)
        {
            return Ok(());
        }
        // `V\left(\frac{m T}{a}\right)^{3/2}`: nobody writes a root of a function in this way. The s of a Laplace transform is no
        // function of anything but the time.
        let is_root = matches!(&next.layout, Layout::Scripts { sub: None, sup: Some(sup), .. } if is_fractional(sup));
        let is_laplace = name.base == "s" && name.subscript.is_empty() && name.primes == 0 && inside.len() > 1;
        let is_quotient = matches!(inside.as_slice(), [Item { layout: Layout::Fraction(..), .. }]);
        if is_root && is_quotient || is_laplace && !self.shifts_the_time(&inside) {
            return Ok(());
        }
        // `P_0 \left(\frac{T}{T_0}\right)^\chi`: a value to which a power of a ratio is a factor.
        let is_ratio = matches!(inside.as_slice(), [Item { layout: Layout::Fraction(..), .. }]);
        if is_powered && is_ratio && !name.subscript.is_empty() && name.primes == 0 {
            return Ok(());
        }
        match is_function(entry) || self.is_at_a_place(name, &inside) || !is_plain_product {
            true => ambiguous(),
            false => Ok(()),
        }
    }

    /// Rejects a parenthesis directly after a quantity if it holds a number, a lone name or a list: `x(0)`, `f(x)`,
    /// `H(q, p)`. `name` is the quantity, for the message.
    pub(super) fn is_no_value(&self, name: &str, span: Span, next: &Item) -> Read<()> {
        let Some((fence, inside)) = parenthesis(next) else { return Ok(()) };
        let span = span.to(fence.span);
        let is_comma = |item: &&Item| matches!(item.layout, Layout::Other(',' | ';'));
        let is_list = inside.iter().any(&is_comma);
        if let [only] = inside.as_slice()
            && let Some((argument, dots)) = self.lone_name(only)
        {
            let argument = names::with_dots(&argument, dots).unwrap_or(argument);
            let message = format!("{name}({argument}) may be a function of {argument} or a product");
            return Err(Fault::ambiguous(span, message)
                .help("for a product, remove the parentheses; for a function, declare it under \"functions\""));
        }
        if is_list {
            return Err(Fault::unsupported(span, format!("{name}(…) has several arguments, which is not supported"))
                .help("write the name without its arguments"));
        }
        if !inside.is_empty() && inside.iter().all(|item| is_value(item)) {
            return Err(Fault::ambiguous(
                span,
                format!("a number in parentheses after {name} may be an argument or a factor"),
            )
            .help(
                "for a product, write \\cdot before the number; for a value, use a name with a subscript, such as x_0",
            ));
        }
        Ok(())
    }

    fn is_sign(&self, item: &Item) -> bool {
        match &item.layout {
            Layout::Other(c) => matches!(c, '+' | '-'),
            Layout::Command(name) => matches!(name.as_str(), "\\pm" | "\\mp"),
            _ => false,
        }
    }

    /// Whether the time stands in a parenthesis as a term or a factor of its own, and in no function.
    fn shifts_the_time(&self, inside: &[&Item]) -> bool {
        let is_time = |item: &Item| names::printed(item, None).map(|printed| printed.name) == self.symbols.time;
        // The t of Δt is no time.
        let is_step = |item: &Item| matches!(&item.layout, Layout::Command(name) if ["\\Delta", "\\delta"].contains(&name.as_str()));
        let is_function = |item: &&Item| matches!(function_head(item), Ok(Some(_)));
        let at = (0..inside.len()).any(|at| is_time(inside[at]) && !(at > 0 && is_step(inside[at - 1])));
        self.symbols.time.is_some() && at && !inside.iter().any(is_function)
    }

    /// `u(x + h)`: a field at a place beside another.
    fn is_at_a_place(&self, name: &Name, inside: &[&Item]) -> bool {
        let is_place = |item: &&Item| {
            let printed = names::printed(item, self.branch).filter(|printed| printed.sup.is_none());
            printed.is_some_and(|printed| ["x", "z"].contains(&printed.name.base.as_str()))
        };
        FIELDS.contains(&name.base.as_str()) && inside.iter().any(is_place)
    }
}
