//! The shapes of symbols, sums, products, powers, functions of matrices, parts of complex numbers and `cases`.

use crate::source::{Fault, Span};

use super::ids::SymbolId;
use super::numbers::complex::Complex;
use super::shape::{Binder, Shape, Type, components, union};
use super::symbols::{Kind, Operator};
use super::text::formula;
use super::tree::{Branch, ComplexPart, Definite, Expr, Function, IndexId, Node, Sign, Term};

impl Binder<'_> {
    /// The shape of a symbol with a number of indices.
    pub(super) fn symbol_shape(&self, id: SymbolId, given: usize, span: Span) -> Result<Shape, Fault> {
        let entry = self.symbols.entry(id);
        let extents = self.symbols.extents(id);
        let shape = match (entry.kind, entry.slots.len(), given) {
            (Kind::Scalar, slots, given) if slots == given => Shape::Scalar,
            (Kind::Scalar, 1, 0) if extents == [3] && !self.is_label(entry.slots[0].1) => Shape::Vector,
            (Kind::Scalar, 2, 0) if !entry.slots.iter().any(|(_, letter)| self.is_label(*letter)) => {
                Shape::Matrix(extents[0].into(), extents[1].into())
            }
            (Kind::Vector, slots, given) if slots == given => Shape::Vector,
            (Kind::Complex, slots, given) if slots == given => Shape::Complex,
            (Kind::Abstract, ..) => Shape::Abstract,
            (Kind::Matrix(rows, columns), slots, given) if slots == given => of_size(rows.into(), columns.into()),
            (Kind::Rotation, ..) => {
                return Err(Fault::new(
                    span,
                    format!("{0} is a rotation, and needs its angle in parentheses, as in {0}(\\theta)", entry.name),
                )
                .help("write the angle after the name"));
            }
            _ => {
                return Err(Fault::index(
                    span,
                    format!("{} has fewer or more indices here than where it is declared or defined", entry.name),
                )
                .help("write the same number of indices in both places"));
            }
        };
        Ok(shape)
    }

    /// The type of a sum: its terms have one shape and the same free indices.
    pub(super) fn sum(&mut self, terms: &mut [Term]) -> Result<Type, Fault> {
        let mut first: Option<Type> = None;
        for at in 0..terms.len() {
            let (before, rest) = terms.split_at_mut(at);
            let term = &mut rest[0];
            let found = self.bind(&mut term.expr)?;
            match &first {
                _ if term.expr.is_zero() => {}
                None => first = Some(found),
                Some(first) if of_sum(first.shape, found.shape).is_none() => {
                    let known = before.iter().map(|term| &term.expr).find(|expr| !expr.is_zero());
                    let sides = [Some((&term.expr, found.shape)), known.map(|known| (known, first.shape))];
                    return Err(self.no_sum(sides.into_iter().flatten()));
                }
                Some(first) if components(&first.free, self.symbols) != components(&found.free, self.symbols) => {
                    return Err(Fault::index(
                        term.expr.span,
                        "this term has other free indices than the terms before it",
                    )
                    .help("write the same free indices in each term"));
                }
                Some(known) => {
                    let shape = of_sum(known.shape, found.shape).unwrap_or(known.shape);
                    first = Some(Type { free: union(&known.free, &found.free), shape });
                }
            }
        }
        Ok(first.unwrap_or(Type { shape: Shape::Scalar, free: Vec::new() }))
    }

    /// Why two terms have no sum, and which of their names are taken for numbers.
    fn no_sum<'t>(&self, terms: impl Iterator<Item = (&'t Expr, Shape)>) -> Fault {
        let terms: Vec<(&Expr, Shape)> = terms.collect();
        let said = |(expr, shape): &(&Expr, Shape)| format!("“{}” is {}", formula(expr, self.symbols), shape.noun());
        let what: Vec<String> = terms.iter().map(said).collect();
        let span = terms.first().map_or(Span::default(), |(expr, _)| expr.span);
        let fault = Fault::shape(span, format!("{}, and they cannot be added", what.join(", ")));
        let mut numbers: Vec<&str> = Vec::new();
        for (expr, _) in &terms {
            expr.walk(&mut |part| {
                if let Node::Symbol { id, .. } = part.node
                    && matches!(self.symbol_shape(id, 0, span), Ok(Shape::Scalar))
                    && !numbers.contains(&self.symbols.entry(id).name.base.as_str())
                {
                    numbers.push(&self.symbols.entry(id).name.base);
                }
            });
        }
        let (are, kind) = if numbers.len() == 1 { ("is", "a number") } else { ("are", "numbers") };
        let has_vector = terms.iter().any(|(_, shape)| *shape == Shape::Vector);
        match (numbers.is_empty(), has_vector) {
            (true, _) => fault.help("write terms that are all numbers, all vectors, or all matrices of one size"),
            (false, true) => fault.help(format!(
                "{} {are} taken for {kind}; mark a vector with \\vec or \\mathbf, and declare a matrix, as in \
                 \"M\": \"4x1 matrix\" under \"constants\"",
                numbers.join(" and ")
            )),
            (false, false) => fault.help(format!(
                "{} {are} taken for {kind}; declare a matrix or a column under \"constants\" or \
                 \"varies with time\", as in \"M\": \"4x1 matrix\"",
                numbers.join(" and ")
            )),
        }
    }

    /// The shape of a product, and the letters of all its factors.
    pub(super) fn product(&mut self, factors: &mut [Expr]) -> Result<(Shape, Vec<IndexId>), Fault> {
        let mut shape = Shape::Scalar;
        let mut letters = Vec::new();
        for factor in factors {
            let found = self.bind(factor)?;
            let has_complex = [shape, found.shape].contains(&Shape::Complex);
            shape = of_product(shape, found.shape).ok_or_else(|| {
                if has_complex {
                    return self.no_complex(factor.span);
                }
                let message = format!("{} cannot be multiplied by {}", shape.noun(), found.shape.noun());
                match (shape, found.shape) {
                    (Shape::Vector, Shape::Vector) => {
                        Fault::shape(factor.span, message).help("multiply two vectors with \\cdot or \\times")
                    }
                    // Columns that are written out are matrices, and \cdot is their product.
                    (Shape::Matrix(a, 1), Shape::Matrix(b, 1)) if a == b => Fault::shape(factor.span, message)
                        .help("for their scalar product write the first as a row: \\begin{pmatrix} a & b \\end{pmatrix}"),
                    (Shape::Matrix(1, a), Shape::Matrix(1, b)) if a == b => Fault::shape(factor.span, message)
                        .help("for their scalar product write the second as a column: \\begin{pmatrix} a \\\\ b \\end{pmatrix}"),
                    _ => Fault::shape(factor.span, message)
                        .help("the first must have as many columns as the second has rows"),
                }
            })?;
            letters.extend(found.free);
        }
        Ok((shape, letters))
    }

    /// The type of a quotient by a number.
    pub(super) fn quotient(&mut self, a: &mut Expr, b: &mut Expr) -> Result<Type, Fault> {
        let found = self.bind(a)?;
        let below = self.number(b, "a denominator")?;
        let shape = of_product(found.shape, below.shape).ok_or_else(|| self.no_complex(a.span))?;
        Ok(Type { free: union(&found.free, &below.free), shape })
    }

    /// The type of an integral over one letter.
    pub(super) fn definite(&mut self, of: &mut Definite) -> Result<Type, Fault> {
        let mut free = self.scalar(&mut of.integrand, "an integrand")?;
        for end in of.lower.iter_mut().chain(&mut of.upper) {
            free = union(&free, &self.scalar(end, "a limit of an integral")?);
        }
        Ok(Type { shape: Shape::Scalar, free })
    }

    /// The type of a function of a number.
    pub(super) fn call(&mut self, function: Function, a: &mut Expr, span: Span) -> Result<Type, Fault> {
        let what = format!("the argument of \\{}", function.name());
        let found = self.number(a, &what)?;
        match found.shape == Shape::Complex && !Complex::<f64>::knows(function) {
            true => Err(Fault::unsupported(
                span,
                format!("\\{} of a complex number has several values, and is not supported", function.name()),
            )
            .help("write an equation for the real part and one for the imaginary part")),
            false => Ok(found),
        }
    }

    /// The type of an operator, or of a function without a formula, with its arguments.
    pub(super) fn applied(&mut self, id: SymbolId, arguments: &mut [Expr]) -> Result<Type, Fault> {
        let entry = self.symbols.entry(id);
        let (kind, operator) = (entry.kind, entry.operator);
        let (mut free, mut last) = (Vec::new(), Shape::Scalar);
        for argument in arguments {
            let found = self.bind(argument)?;
            free = union(&free, &found.free);
            last = found.shape;
        }
        let shape = match (operator, kind) {
            (Some(Operator::Same), _) => last,
            (Some(Operator::Template), _) | (_, Kind::Abstract) => Shape::Abstract,
            (Some(Operator::ToVector), _) | (Some(Operator::Function), Kind::Vector) => Shape::Vector,
            _ => Shape::Scalar,
        };
        Ok(Type { shape, free })
    }

    /// The letters of two factors that must be vectors.
    pub(super) fn two_vectors(&mut self, a: &mut Expr, b: &mut Expr) -> Result<Vec<IndexId>, Fault> {
        let (left, right) = (self.bind(a)?, self.bind(b)?);
        for (side, found) in [(&*a, &left), (&*b, &right)] {
            if found.shape != Shape::Vector {
                let message = format!("this must be a vector, but it is {}", found.shape.noun());
                return Err(Fault::shape(side.span, message)
                    .help("mark each vector with \\vec or \\mathbf, or remove the sign of the product"));
            }
        }
        Ok(left.free.into_iter().chain(right.free).collect())
    }

    /// The type of a matrix that is written out.
    pub(super) fn matrix(&mut self, rows: &mut [Vec<Expr>], span: Span) -> Result<Type, Fault> {
        let columns = rows.first().map_or(0, Vec::len);
        let count = rows.len();
        let mut free = Vec::new();
        for row in rows {
            if row.len() != columns {
                return Err(Fault::shape(span, "the rows of this matrix have different lengths")
                    .help("write the same number of entries in each row"));
            }
            for entry in row {
                let found = self.bind(entry)?;
                if found.shape == Shape::Complex && !self.symbols.is_abstract() {
                    return Err(Fault::shape(entry.span, "complex matrices are not supported")
                        .help("leave the display out with \"skip\" in a claims file"));
                }
                free = union(&free, &self.scalar_labels(found, entry.span, "an entry of a matrix")?);
            }
        }
        Ok(Type { shape: of_size(count, columns), free })
    }

    /// The type of a power, of a function of a matrix, of a part of a complex number, or of cases.
    pub(super) fn operator(&mut self, expr: &mut Expr) -> Result<Type, Fault> {
        let span = expr.span;
        match &mut expr.node {
            Node::Power(a, b) => {
                if a.node == Node::Euler {
                    return self.number(b, "an exponent");
                }
                let labels = self.scalar(b, "an exponent")?;
                let found = self.bind(a)?;
                let is_whole =
                    b.as_digits().is_some_and(|digits| digits.parse().is_ok_and(|n: u32| (1..=64).contains(&n)));
                match found.shape {
                    Shape::Scalar => {}
                    Shape::Matrix(rows, columns) if rows == columns && is_whole => return Ok(found),
                    Shape::Complex if is_whole || is_negative_whole(b) => return Ok(found),
                    Shape::Complex => {
                        return Err(Fault::unsupported(span, "this power of a complex number has several values")
                            .help("write it with e^{…}"));
                    }
                    _ => {
                        let fault = Fault::shape(span, format!("{} cannot have this power", found.shape.noun()));
                        return Err(match found.shape {
                            Shape::Matrix(rows, columns) if rows == columns => {
                                fault.help("the exponent of a square matrix must be a whole number from 1 to 64, or -1")
                            }
                            Shape::Matrix(..) => fault.help("only a square matrix has powers"),
                            _ => fault.help("write the power of a component, or the square of its norm"),
                        });
                    }
                }
                if found.free.iter().any(|letter| !self.is_label(*letter)) {
                    return Err(Fault::ambiguous(
                        span,
                        "v_a^2 may be the square of one component or the sum of all squares, v_a v_a",
                    )
                    .help("for the sum, write \\sum_a v_a^2 or v_a v_a"));
                }
                Ok(Type { free: union(&found.free, &labels), ..found })
            }
            Node::Transpose(a) => {
                let found = self.bind(a)?;
                match found.shape {
                    Shape::Vector => Ok(Type { shape: Shape::Matrix(1, 3), free: found.free }),
                    Shape::Matrix(rows, columns) => Ok(Type { shape: of_size(columns, rows), free: found.free }),
                    other => Err(Fault::shape(span, format!("{} has no transpose", other.noun()))
                        .help("declare the name as a matrix, as in \"M\": \"3x3 matrix\", or remove the transpose")),
                }
            }
            Node::Inverse(a) => {
                let found = self.bind(a)?;
                match found.shape {
                    Shape::Matrix(rows, columns) if rows == columns => Ok(found),
                    other => Err(Fault::shape(span, format!("{} has no inverse matrix", other.noun()))
                        .help("only a square matrix has one; declare the matrix, or write it out")),
                }
            }
            Node::OfMatrix(function, a) => {
                let found = self.bind(a)?;
                match found.shape {
                    Shape::Matrix(rows, columns) if rows == columns => Ok(Type { shape: Shape::Scalar, ..found }),
                    other => {
                        let message = format!("{} has no {}", other.noun(), function.word());
                        Err(Fault::shape(span, message)
                            .help("only a square matrix has one; declare the matrix, or write it out"))
                    }
                }
            }
            Node::Commutator(a, b) => {
                let (left, right) = (self.bind(a)?, self.bind(b)?);
                match (left.shape, right.shape) {
                    (Shape::Matrix(n, m), Shape::Matrix(k, l)) if n == m && k == l && (n == k || n * k == 0) => {
                        Ok(Type { shape: Shape::Matrix(n.max(k), n.max(k)), free: union(&left.free, &right.free) })
                    }
                    _ => Err(Fault::shape(span, "a commutator needs two square matrices of the same size")
                        .help("declare both as matrices, as in \"A\": \"3x3 matrix\", or write them out")),
                }
            }
            Node::Complex(part, a) => {
                let found = self.number(a, "this")?;
                let shape = if *part == ComplexPart::Conjugate { found.shape } else { Shape::Scalar };
                Ok(Type { shape, ..found })
            }
            Node::Cases(branches) => self.cases(branches, span),
            _ => Err(Fault::new(span, "this formula is not a number, a vector or a matrix")),
        }
    }

    /// The type of a real or complex number.
    pub(super) fn number(&mut self, expr: &mut Expr, what: &str) -> Result<Type, Fault> {
        let found = self.bind(expr)?;
        match found.shape {
            Shape::Complex if found.free.iter().all(|letter| self.is_label(*letter)) => Ok(found),
            _ => self.scalar_labels(found, expr.span, what).map(|free| Type { shape: Shape::Scalar, free }),
        }
    }

    pub(super) fn no_complex(&self, span: Span) -> Fault {
        Fault::unsupported(span, "vectors and matrices of complex numbers are not supported")
            .help("write an equation for each component")
    }

    /// All rows of `cases` have one shape; their conditions compare numbers.
    fn cases(&mut self, branches: &mut [Branch], span: Span) -> Result<Type, Fault> {
        let mut all: Option<Type> = None;
        for branch in branches {
            let found = self.bind(&mut branch.value)?;
            for member in branch.conditions.iter_mut().flat_map(|condition| &mut condition.members) {
                self.scalar(member, "each side of a condition")?;
            }
            all = Some(match all {
                None => found,
                Some(known) => {
                    let shape = of_sum(known.shape, found.shape).ok_or_else(|| {
                        Fault::shape(
                            branch.value.span,
                            "the cases must be all numbers, all vectors, or all matrices of the same size",
                        )
                        .help("write formulas of one kind in all rows")
                    })?;
                    Type { shape, free: union(&known.free, &found.free) }
                }
            });
        }
        all.ok_or_else(|| {
            Fault::new(span, "this definition by cases has no rows").help("write a value and a condition in each row")
        })
    }
}

/// Whether an exponent is a negative whole number.
fn is_negative_whole(exponent: &Expr) -> bool {
    match &exponent.node {
        Node::Sum(terms) => terms.len() == 1 && terms[0].sign == Sign::Minus && terms[0].expr.as_digits().is_some(),
        _ => false,
    }
}

/// The shape of a matrix with these rows and columns.
pub fn of_size(rows: usize, columns: usize) -> Shape {
    match (rows, columns) {
        (1, 1) => Shape::Scalar,
        (3, 1) => Shape::Vector,
        _ => Shape::Matrix(rows, columns),
    }
}

/// The rows and columns of a matrix, or of a vector as a column.
fn size(shape: Shape) -> Option<(usize, usize)> {
    match shape {
        Shape::Scalar | Shape::Complex | Shape::Abstract => None,
        Shape::Vector => Some((3, 1)),
        Shape::Matrix(rows, columns) => Some((rows, columns)),
    }
}

/// The shape of the sum of two shapes, where it is defined.
pub fn of_sum(a: Shape, b: Shape) -> Option<Shape> {
    match (a, b) {
        _ if a == b => Some(a),
        (Shape::Abstract, _) | (_, Shape::Abstract) => Some(Shape::Abstract),
        (Shape::Scalar, Shape::Complex) | (Shape::Complex, Shape::Scalar) => Some(Shape::Complex),
        (Shape::Matrix(0, 0), Shape::Matrix(n, m)) | (Shape::Matrix(n, m), Shape::Matrix(0, 0)) if n == m => {
            Some(Shape::Matrix(n, n))
        }
        _ => None,
    }
}

/// The shape of a product of two factors in this order; `None` where it is not defined. Two vectors have none: they need
/// a sign between them.
pub fn of_product(a: Shape, b: Shape) -> Option<Shape> {
    match (a, b) {
        (Shape::Abstract, _) | (_, Shape::Abstract) => Some(Shape::Abstract),
        (Shape::Scalar, other) | (other, Shape::Scalar) => Some(other),
        (Shape::Complex, Shape::Complex) => Some(Shape::Complex),
        (Shape::Vector, Shape::Vector) => None,
        (Shape::Matrix(0, 0), other) => Some(other),
        (other, Shape::Matrix(0, 0)) => (other != Shape::Vector).then_some(other),
        _ => {
            let ((rows, inner), (other, columns)) = (size(a)?, size(b)?);
            (inner == other).then(|| of_size(rows, columns))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_have_the_shape_of_their_values() {
        let (row, column, square) = (Shape::Matrix(1, 2), Shape::Matrix(2, 1), Shape::Matrix(2, 2));
        assert_eq!(of_product(row, column), Some(Shape::Scalar));
        assert_eq!(of_product(column, row), Some(square));
        assert_eq!(of_product(square, column), Some(column));
        assert_eq!(of_product(column, square), None);
        assert_eq!(of_product(Shape::Vector, Shape::Vector), None);
        assert_eq!(of_product(Shape::Matrix(1, 3), Shape::Vector), Some(Shape::Scalar));
        assert_eq!(of_product(Shape::Vector, Shape::Matrix(1, 3)), Some(Shape::Matrix(3, 3)));
    }
}
