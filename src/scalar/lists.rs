//! Lists of numbers, made entry by entry.
//!
//! `iter().map(f).collect()` is compiled for each closure, some ten functions each time, and where the number is generic,
//! for each of some twenty numbers. These functions are compiled once for each type of entry.

/// `f` of every entry.
pub(crate) fn each<A, B>(entries: &[A], f: &dyn Fn(&A) -> B) -> Vec<B> {
    let mut all = Vec::with_capacity(entries.len());
    for entry in entries {
        all.push(f(entry));
    }
    all
}

/// `f` of 0, 1, …, `n` − 1.
pub(crate) fn up_to<B>(n: usize, f: &mut dyn FnMut(usize) -> B) -> Vec<B> {
    let mut all = Vec::with_capacity(n);
    for k in 0..n {
        all.push(f(k));
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_what_iterators_collect() {
        let list = [3, 1, 4, 1, 5];
        assert_eq!(each(&list, &|x| x * 2), list.iter().map(|x| x * 2).collect::<Vec<_>>());
        assert_ne!(each(&list, &|x| x * 2), list);
        assert_eq!(up_to(3, &mut |k| k * k), [0, 1, 4]);
        assert!(up_to(0, &mut |k| k).is_empty());
    }
}
