//! Runs a computation compiled for the vectors that the machine has.
//!
//! A program for any x86-64 processor may use vectors of 128 bits only. [`widest`] compiles a
//! [`Task`] a second time, for AVX2 (256 bits) and FMA (`a*b + c` in one instruction), and asks
//! the processor which of the two to run. Both are the same Rust: they give the same results, at
//! another speed. On other processors there is one.

/// A computation worth compiling twice.
pub trait Task {
    /// What it comes to.
    type Output;

    /// Runs it. Marked `#[inline(always)]`, as what it calls in its loops should be: a function
    /// that is not inlined is compiled once, for the narrow vectors.
    ///
    /// `fused`: whether [`f64::mul_add`] is one instruction here. A constant wherever this is
    /// compiled; a task that uses it for anything but speed would not be the same everywhere.
    fn run(self, fused: bool) -> Self::Output;
}

/// Runs a task with the widest vectors that this program knows and this processor has.
#[inline]
pub fn widest<T: Task>(task: T) -> T::Output {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma") {
        #[target_feature(enable = "avx2,fma")]
        fn with_avx2<T: Task>(task: T) -> T::Output {
            task.run(true)
        }
        // SAFETY: the processor has AVX2 and FMA, which is all that `with_avx2` asks for.
        return unsafe { with_avx2(task) };
    }
    task.run(cfg!(any(target_feature = "fma", target_arch = "aarch64")))
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Sum<'a>(&'a [i32], &'a [i32]);

    impl Task for Sum<'_> {
        type Output = Vec<i32>;

        #[inline(always)]
        fn run(self, _: bool) -> Vec<i32> {
            self.0.iter().zip(self.1).map(|(a, b)| a.wrapping_mul(*b)).collect()
        }
    }

    #[test]
    fn both_compilations_agree() {
        let a: Vec<i32> = (0..1000).map(|x| x * 765_432).collect();
        let b: Vec<i32> = (0..1000).map(|x| x * x - 99).collect();
        let wanted = Sum(&a, &b).run(false);
        assert_eq!(widest(Sum(&a, &b)), wanted);
        assert_eq!(wanted[999], (999i32 * 765_432).wrapping_mul(999 * 999 - 99));
    }
}
