import CordonMirror.Spec.Formation
import CordonMirror.Thm.Sum

/-! Consensus and formation on any undirected graph: what happens to the sum. -/

namespace CordonMirror

theorem foldl_filter (P : Nat → Bool) (F : Nat → Rat) (n : Nat) :
    ∀ (f : Nat → Nat) (c : Rat),
      List.foldl (fun (a : Rat) (j : Nat) => a + F j) c (List.filter P (lambda n f))
        = c + sumn (fun i => if P (f i) = true then F (f i) else 0) n := by
  induction n with
  | zero =>
    intro f c
    show c = c + 0
    grind
  | succ n ih =>
    intro f c
    have hs : sumn (fun i => if P (f i) = true then F (f i) else 0) (n + 1)
        = (if P (f 0) = true then F (f 0) else 0)
          + sumn (fun i => if P (f (i + 1)) = true then F (f (i + 1)) else 0) n :=
      sumn_shift (fun i => if P (f i) = true then F (f i) else 0) n
    have hl : lambda (n + 1) f = f 0 :: lambda n (fun i => f (i + 1)) := rfl
    rw [hs, hl]
    by_cases hP : P (f 0) = true
    · have hf : List.filter P (f 0 :: lambda n (fun i => f (i + 1)))
          = f 0 :: List.filter P (lambda n (fun i => f (i + 1))) := by
        first
          | exact List.filter_cons_of_pos hP
          | simp [List.filter, hP]
      have h : List.foldl (fun (a : Rat) (j : Nat) => a + F j) (c + F (f 0))
            (List.filter P (lambda n (fun i => f (i + 1))))
          = (c + F (f 0))
            + sumn (fun i => if P (f (i + 1)) = true then F (f (i + 1)) else 0) n :=
        ih (fun i => f (i + 1)) (c + F (f 0))
      have hi : (if P (f 0) = true then F (f 0) else 0) = F (f 0) := if_pos hP
      rw [hf, hi]
      exact Eq.trans h (Rat.add_assoc c (F (f 0))
        (sumn (fun i => if P (f (i + 1)) = true then F (f (i + 1)) else 0) n))
    · have hf : List.filter P (f 0 :: lambda n (fun i => f (i + 1)))
          = List.filter P (lambda n (fun i => f (i + 1))) := by
        first
          | exact List.filter_cons_of_neg hP
          | simp [List.filter, hP]
      have h : List.foldl (fun (a : Rat) (j : Nat) => a + F j) c
            (List.filter P (lambda n (fun i => f (i + 1))))
          = c + sumn (fun i => if P (f (i + 1)) = true then F (f (i + 1)) else 0) n :=
        ih (fun i => f (i + 1)) c
      have hi : (if P (f 0) = true then F (f 0) else 0) = 0 := if_neg hP
      rw [hf, hi, Rat.zero_add]
      exact h

/-- What drone `i` feels of drone `j`. -/
def link_pull (g : Graph) (x : DroneMap Rat) (i j : Nat) : Rat :=
  if g.linked i j = true then get x j - get x i else 0

theorem pull_sumn (g : Graph) (x : DroneMap Rat) (i : Nat) :
    pull g x i = sumn (link_pull g x i) g.count := by
  have h : pull g x i = 0 + sumn (link_pull g x i) g.count :=
    foldl_filter (fun j => g.linked i j) (fun j => get x j - get x i) g.count (fun j => j) 0
  grind

theorem link_pull_opposite (g : Graph) (x : DroneMap Rat) (i j : Nat)
    (hg : g.linked i j = g.linked j i) : link_pull g x i j = -1 * link_pull g x j i := by
  unfold link_pull
  rw [hg]
  by_cases h : g.linked j i = true
  · have a : (if g.linked j i = true then get x j - get x i else 0) = get x j - get x i :=
      if_pos h
    have b : (if g.linked j i = true then get x i - get x j else 0) = get x i - get x j :=
      if_pos h
    rw [a, b]
    grind
  · have a : (if g.linked j i = true then get x j - get x i else 0) = 0 := if_neg h
    have b : (if g.linked j i = true then get x i - get x j else 0) = 0 := if_neg h
    rw [a, b]
    grind

theorem sumn_swap (F : Nat → Nat → Rat) (m : Nat) (n : Nat) :
    sumn (fun i => sumn (F i) m) n = sumn (fun j => sumn (fun i => F i j) n) m := by
  induction n with
  | zero =>
    have h : sumn (fun j => sumn (fun i => F i j) 0) m = 0 :=
      sumn_zero (fun j => sumn (fun i => F i j) 0) m (fun _ _ => rfl)
    exact Eq.symm h
  | succ n ih =>
    have h : sumn (fun j => sumn (fun i => F i j) n + F n j) m
        = sumn (fun j => sumn (fun i => F i j) n) m + sumn (F n) m :=
      sumn_add (fun j => sumn (fun i => F i j) n) (F n) m
    have h2 : sumn (fun i => sumn (F i) m) (n + 1)
        = sumn (fun i => sumn (F i) m) n + sumn (F n) m := rfl
    have h3 : sumn (fun j => sumn (fun i => F i j) (n + 1)) m
        = sumn (fun j => sumn (fun i => F i j) n + F n j) m := rfl
    rw [h2, h3, h, ih]

/-- What one drone gains through a link the other loses. -/
theorem pulls_cancel (g : Graph) (x : DroneMap Rat)
    (hg : ∀ i j : Nat, g.linked i j = g.linked j i) : sumn (pull g x) g.count = 0 := by
  have h1 : sumn (pull g x) g.count
      = sumn (fun i => sumn (link_pull g x i) g.count) g.count :=
    sumn_ext (pull g x) (fun i => sumn (link_pull g x i) g.count) g.count
      (fun i _ => pull_sumn g x i)
  have h2 : sumn (fun i => sumn (link_pull g x i) g.count) g.count
      = sumn (fun j => sumn (fun i => link_pull g x i j) g.count) g.count :=
    sumn_swap (link_pull g x) g.count g.count
  have h3 : sumn (fun j => sumn (fun i => link_pull g x i j) g.count) g.count
      = sumn (fun j => -1 * sumn (link_pull g x j) g.count) g.count := by
    refine sumn_ext _ _ g.count ?_
    intro j _
    have a : sumn (fun i => link_pull g x i j) g.count
        = sumn (fun i => -1 * link_pull g x j i) g.count :=
      sumn_ext (fun i => link_pull g x i j) (fun i => -1 * link_pull g x j i) g.count
        (fun i _ => link_pull_opposite g x i j (hg i j))
    exact Eq.trans a (sumn_scale (-1) (link_pull g x j) g.count)
  have h4 : sumn (fun j => -1 * sumn (link_pull g x j) g.count) g.count
      = -1 * sumn (fun j => sumn (link_pull g x j) g.count) g.count :=
    sumn_scale (-1) (fun j => sumn (link_pull g x j) g.count) g.count
  grind

theorem sum_lambda (n : Nat) (f : Nat → Rat) : sum (lambda n f) = sumn f n := by
  have h : sum (lambda n f) = sumn (get (lambda n f)) (count (lambda n f)) :=
    sum_sumn (lambda n f)
  rw [count_lambda] at h
  exact Eq.trans h (sumn_ext (get (lambda n f)) f n (fun i hi => get_lambda n f i hi))

/-- Formation moves the sum by `eps` times the sum of its input. -/
theorem formation_sum (eps : Rat) (g : Graph) (x b : DroneMap Rat)
    (hg : ∀ i j : Nat, g.linked i j = g.linked j i) (hc : g.count = count x)
    (hb : count b = count x) : sum (exec_formation eps g x b) = sum x + eps * sum b := by
  have h1 : sum (exec_formation eps g x b)
      = sumn (fun i => get x i + eps * (pull g x i + get b i)) (count x) :=
    sum_lambda (count x) (fun i => get x i + eps * (pull g x i + get b i))
  have h2 : sumn (fun i => get x i + eps * (pull g x i + get b i)) (count x)
      = sumn (get x) (count x) + sumn (fun i => eps * (pull g x i + get b i)) (count x) :=
    sumn_add (get x) (fun i => eps * (pull g x i + get b i)) (count x)
  have h3 : sumn (fun i => eps * (pull g x i + get b i)) (count x)
      = eps * sumn (fun i => pull g x i + get b i) (count x) :=
    sumn_scale eps (fun i => pull g x i + get b i) (count x)
  have h4 : sumn (fun i => pull g x i + get b i) (count x)
      = sumn (pull g x) (count x) + sumn (get b) (count x) :=
    sumn_add (pull g x) (get b) (count x)
  have h5 : sumn (pull g x) (count x) = 0 := by
    rw [← hc]
    exact pulls_cancel g x hg
  have h6 : sum x = sumn (get x) (count x) := sum_sumn x
  have h7 : sum b = sumn (get b) (count x) := by
    have h : sum b = sumn (get b) (count b) := sum_sumn b
    rw [hb] at h
    exact h
  rw [h1, h2, h3, h4, h5, h6, h7]
  grind

/-- Without input, formation is consensus. -/
theorem formation_without_input (eps : Rat) (g : Graph) (x b : DroneMap Rat)
    (hb : ∀ i : Nat, i < count x → get b i = 0) :
    exec_formation eps g x b = exec_consensus eps g x := by
  have h : ∀ i : Nat, i < count x →
      get x i + eps * (pull g x i + get b i) = get x i + eps * pull g x i := by
    intro i hi
    have hz : get b i = 0 := hb i hi
    rw [hz]
    grind
  exact lambda_ext (count x) (fun i => get x i + eps * (pull g x i + get b i))
    (fun i => get x i + eps * pull g x i) h

/-- Consensus preserves the sum on any undirected graph, for every weight. -/
theorem consensus_sum (eps : Rat) (g : Graph) (x : DroneMap Rat)
    (hg : ∀ i j : Nat, g.linked i j = g.linked j i) (hc : g.count = count x) :
    sum (exec_consensus eps g x) = sum x := by
  have h1 : sum (exec_consensus eps g x)
      = sumn (fun i => get x i + eps * pull g x i) (count x) :=
    sum_lambda (count x) (fun i => get x i + eps * pull g x i)
  have h2 : sumn (fun i => get x i + eps * pull g x i) (count x)
      = sumn (get x) (count x) + sumn (fun i => eps * pull g x i) (count x) :=
    sumn_add (get x) (fun i => eps * pull g x i) (count x)
  have h3 : sumn (fun i => eps * pull g x i) (count x) = eps * sumn (pull g x) (count x) :=
    sumn_scale eps (pull g x) (count x)
  have h4 : sumn (pull g x) (count x) = 0 := by
    rw [← hc]
    exact pulls_cancel g x hg
  have h5 : sum x = sumn (get x) (count x) := sum_sumn x
  rw [h1, h2, h3, h4, h5]
  grind

end CordonMirror
