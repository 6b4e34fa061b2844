(* The finite forms of the theorems, as the Rust evaluates them, against what
   they stand for: statements about all later steps, and a limit.  They hold for
   plain steps, where every drone moves and sees the present; for activation
   schedules and delays they do not, and two runs at the end show it. *)
From Coq Require Import Reals Lra Lia ZArith Arith List QArith.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Activation Spec.Delay.
From Cordon Require Import Spec.Theorems.Hypothesis Spec.Theorems.Statements.
From Cordon Require Import Proofs.Real Proofs.Rational Proofs.Dynamics Proofs.Ordering.
From Cordon Require Import Proofs.UpperBound Proofs.Sum Proofs.NonDecreasing Proofs.Increasing.
From Cordon Require Import Proofs.FixedPoint Proofs.Limit Proofs.ExactLimit Proofs.Critical.
From Cordon Require Import Proofs.Activation Proofs.Delay.
Local Open Scope R_scope.

(* The placements from step k on. *)
Definition from_step (p : Params R) (s : State R) (k h : nat) : DroneMap R :=
  drones (protocol_step p s (k + h)).

Lemma count_from_step : forall p s k h, count (from_step p s k h) = count (drones s).
Proof. intros; apply count_protocol_step. Qed.

(* ---- Enough zeros in a row are zeros for ever ---- *)

(* The internal errors obey a linear recurrence of order N-2, so that N-2 equal
   sums would be enough by Cayley and Hamilton.  By symmetry half as many are:
   where drones 1 and N-2 have opposite errors for m steps, drones i and N-1-i
   have opposite errors at the first of them, for i = 1 .. m. *)
Section Zeros.
Variables (M : nat) (e : R) (E : nat -> nat -> R).
Hypothesis HE : run M e E.
Hypothesis E0 : forall k, E k O = 0.
Hypothesis EM : forall k, E k M = 0.
Hypothesis HM : (2 <= M)%nat.

Definition paired (k i : nat) : R := E k i + E k (M - i)%nat.

Lemma paired_first : forall k, paired k O = 0.
Proof. intros k; unfold paired; rewrite Nat.sub_0_r, E0, EM; ring. Qed.

Lemma paired_step : forall k i, (S i < M)%nat ->
  paired (S k) (S i) = e * paired k i + (1 - 2 * e) * paired k (S i) + e * paired k (S (S i)).
Proof.
  intros k i Hi; unfold paired.
  rewrite (step_inner _ _ _ _ (HE k) i Hi).
  pose proof (step_inner _ _ _ _ (run_mirror M e E HE k) i Hi) as H; cbv beta in H.
  rewrite H; ring.
Qed.

Lemma zeros_spread : forall m k, e <> 0 -> (m < M)%nat ->
  (forall h, (h < m)%nat -> paired (k + h) 1 = 0) ->
  forall i, (i <= m)%nat -> forall h, (h + i <= m)%nat -> paired (k + h) i = 0.
Proof.
  intros m k He Hm H0 i; induction i as [i IH] using lt_wf_ind; intros Hi h Hh.
  destruct i as [|[|i]]; [apply paired_first|apply H0; lia|].
  pose proof (paired_step (k + h) i ltac:(lia)) as Hs.
  pose proof (IH (S i) ltac:(lia) ltac:(lia) (S h) ltac:(lia)) as Z1.
  rewrite <- plus_n_Sm in Z1.
  rewrite Z1, (IH (S i) ltac:(lia) ltac:(lia) h ltac:(lia)), (IH i ltac:(lia) ltac:(lia) h ltac:(lia)) in Hs.
  assert (Hz : e * paired (k + h) (S (S i)) = 0) by lra.
  apply Rmult_integral in Hz; destruct Hz; [contradiction|assumption].
Qed.

Lemma paired_symmetric : forall k i, (i <= M)%nat -> paired k (M - i) = paired k i.
Proof.
  intros k i Hi; unfold paired; replace (M - (M - i))%nat with i by lia; ring.
Qed.

Lemma zeros_stay : forall k, (forall i, (i <= M)%nat -> paired k i = 0) ->
  forall h i, (i <= M)%nat -> paired (k + h) i = 0.
Proof.
  intros k H h; induction h as [|h IH]; intros i Hi; [rewrite Nat.add_0_r; apply H; exact Hi|].
  rewrite <- plus_n_Sm.
  destruct i as [|i]; [apply paired_first|].
  destruct (Nat.eq_dec (S i) M) as [->|Hne].
  - rewrite <- (paired_symmetric _ M (le_n M)), Nat.sub_diag; apply paired_first.
  - rewrite paired_step, !IH by lia; ring.
Qed.

Lemma zeros_for_ever : forall m k, (M <= 2 * m + 1)%nat ->
  (forall h, (h < m)%nat -> e * paired (k + h) 1 = 0) ->
  forall h, e * paired (k + h) 1 = 0.
Proof.
  intros m k Hm H0 h.
  destruct (Req_dec e 0) as [->|He]; [ring|].
  assert (H1 : forall h, (h < m)%nat -> paired (k + h) 1 = 0).
  { intros t Ht; specialize (H0 t Ht); apply Rmult_integral in H0; tauto. }
  set (m' := Nat.min m (M - 1)).
  assert (Hall : forall i, (i <= M)%nat -> paired k i = 0).
  { assert (Hlow : forall i, (i <= m')%nat -> paired k i = 0).
    { intros i Hi.
      pose proof (zeros_spread m' k He ltac:(unfold m'; lia)
        (fun t Ht => H1 t ltac:(unfold m' in Ht; lia)) i Hi 0 ltac:(lia)) as Z.
      rewrite Nat.add_0_r in Z; exact Z. }
    intros i Hi; destruct (Nat.le_gt_cases i m') as [Hle|Hgt]; [apply Hlow; exact Hle|].
    rewrite <- paired_symmetric by exact Hi; apply Hlow; unfold m' in *; lia. }
  rewrite zeros_stay; [ring|exact Hall|lia].
Qed.
End Zeros.

Lemma increment : forall p (s : State R) k, (3 <= count (drones s))%nat -> anchored p (drones s) ->
  c p s (S k) - c p s k = p_eps p * paired (count (drones s) - 1) (error p s) k 1.
Proof.
  intros p s k Hn Ha; set (M := (count (drones s) - 1)%nat).
  rewrite !c_sumn; replace (count (drones s)) with (S M) by (unfold M; lia).
  rewrite (sum_increment M (p_eps p) (p_min p) (p_max p) (positions p s)).
  - unfold paired; rewrite !error_errors; fold M; reflexivity.
  - unfold M; lia.
  - apply positions_run; assumption.
  - exact (proj1 Ha).
  - exact (proj2 Ha).
Qed.

(* Equal sums over half the internal drones, rounded up, are equal for ever:
   every weight, every anchored start, plain steps. *)
Theorem equal_sums_for_ever : forall p (s : State R) k m,
  (3 <= count (drones s))%nat -> anchored p (drones s) -> (count (drones s) <= 2 * m + 2)%nat ->
  (forall h, (1 <= h <= m)%nat -> c p s (k + h) = c p s k) ->
  forall h, c p s (k + h) = c p s k.
Proof.
  intros p s k m Hn Ha Hm Hc.
  destruct (error_ends p s Hn Ha) as [E0 EM].
  pose proof (error_run p s Hn Ha) as HE.
  assert (Hzero : forall h, p_eps p * paired (count (drones s) - 1) (error p s) (k + h) 1 = 0).
  { apply (zeros_for_ever (count (drones s) - 1) (p_eps p) (error p s) HE E0 EM ltac:(lia) m);
      [lia|].
    intros h Hh; rewrite <- increment by assumption.
    rewrite plus_n_Sm, (Hc (S h)) by lia.
    destruct h as [|h]; [rewrite Nat.add_0_r; ring|rewrite (Hc (S h)) by lia; ring]. }
  intros h; induction h as [|h IH]; [rewrite Nat.add_0_r; reflexivity|].
  rewrite <- plus_n_Sm.
  pose proof (increment p s (k + h) Hn Ha) as Hi; rewrite Hzero in Hi; lra.
Qed.

Lemma half_internal : forall N, (3 <= N)%nat -> (N <= 2 * ((Nat.max (N - 2) 1 + 1) / 2) + 2)%nat.
Proof.
  intros N HN; rewrite Nat.max_l by lia.
  pose proof (Nat.div_mod (N - 2 + 1) 2 ltac:(lia)).
  pose proof (Nat.mod_upper_bound (N - 2 + 1) 2 ltac:(lia)). lia.
Qed.

(* Some step of finitely many has the property, or none has it. *)
Lemma finite_or : forall (P : nat -> Prop) n, (forall h, P h \/ ~ P h) ->
  (exists h, (1 <= h < n)%nat /\ P h) \/ (forall h, (1 <= h < n)%nat -> ~ P h).
Proof.
  intros P n Hdec; induction n as [|n [[h [Hh Ph]]|IH]].
  - right; intros h Hh; lia.
  - left; exists h; split; [lia|exact Ph].
  - destruct (Nat.eq_dec n 0) as [->|Hn]; [right; intros h Hh; lia|].
    destruct (Hdec n) as [Pn|Pn]; [left; exists n; split; [lia|exact Pn]|].
    right; intros h Hh; destruct (Nat.eq_dec h n) as [->|Hne]; [exact Pn|apply IH; lia].
Qed.

(* The finite form of each theorem says what the statement for all later steps
   says: of every anchored start, but the printed 7.7, where sums that fall are
   told from sums that stay by UB and 0 <= eps <= 1/2. *)
Theorem conclusion_for_ever : forall form th p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) ->
  (th = GloballyIncreasing -> form = Paper -> 0 <= p_eps p <= 1/2 /\ upper_bounded p (drones s)) ->
  forall k, conclusion form th p (from_step p s k) <-> for_ever form th p (from_step p s k).
Proof.
  intros form th p s Hn Ha Hinc k; set (N := count (drones s)) in *.
  assert (HN : forall h, count (from_step p s k h) = N) by (intros; apply count_from_step).
  assert (Hsum : forall h, sum (from_step p s k h) = c p s (k + h)) by reflexivity.
  assert (Hnow : sum (from_step p s k 0) = c p s k) by (rewrite Hsum, Nat.add_0_r; reflexivity).
  (* at the targets nothing moves, in either reading *)
  assert (Hstay : at_targets p (from_step p s k 0) -> forall h, from_step p s k h = from_step p s k 0).
  { unfold from_step; rewrite Nat.add_0_r; intros Ht h; apply targets_fixed_sharp; assumption. }
  (* equal sums over the span are equal for ever *)
  assert (Hequal : forall m, (N <= 2 * m + 2)%nat ->
    (forall h, (1 <= h <= m)%nat -> sum (from_step p s k 0) = sum (from_step p s k h)) ->
    forall h, sum (from_step p s k 0) = sum (from_step p s k h)).
  { intros m Hm H h; rewrite Hnow, Hsum; symmetry.
    apply (equal_sums_for_ever p s k m Hn Ha Hm); intros t Ht.
    specialize (H t Ht); rewrite Hnow, Hsum in H; symmetry; exact H. }
  assert (Hconstant : forall m, (N <= 2 * m + 2)%nat ->
    ((forall h, (1 <= h <= m)%nat -> sum (from_step p s k 0) = sum (from_step p s k h)) ->
       at_targets p (from_step p s k 0)) <->
    ((forall h, (1 <= h)%nat -> sum (from_step p s k 0) = sum (from_step p s k h)) ->
       at_targets p (from_step p s k 0))).
  { intros m Hm; split; intros H Hall; apply H.
    - intros h Hh; apply Hall; lia.
    - intros h _; apply (Hequal m Hm); exact Hall. }
  assert (Hmax : (Nat.max (N - 2) 1 = N - 2)%nat) by lia.
  destruct th, form; try (exact (iff_refl _)); unfold conclusion, for_ever; cbv zeta; rewrite ?HN;
    unfold span; cbv zeta; rewrite ?Hmax.
  - split; intros _ Ht h _; rewrite (Hstay Ht h); reflexivity.
  - split; intros _ Ht h _; rewrite (Hstay Ht h); exact Ht.
  - apply Hconstant; lia.
  - apply Hconstant; rewrite <- Hmax at 1; apply half_internal; exact Hn.
  - (* an increase within the span, or none at all *)
    destruct (Hinc eq_refl eq_refl) as [He Hu].
    change (less (T := R)) with Rlt.
    split; intros H Hc Hl; destruct (H Hc Hl) as [h [Hh Hlt]];
      [exists h; split; [lia|exact Hlt]|].
    destruct (finite_or (fun h => sum (from_step p s k h) < sum (from_step p s k (h + 1)))
                (N - 2 + 1)) as [Hyes|Hno].
    + intros t; destruct (Rlt_dec (sum (from_step p s k t)) (sum (from_step p s k (t + 1)))); tauto.
    + exact Hyes.
    + exfalso; rewrite !Hsum in Hlt.
      assert (Hflat : forall t, c p s (k + 1 + t) = c p s (k + 1)).
      { apply equal_sums_for_ever with (m := (N - 2)%nat); [exact Hn|exact Ha|fold N; lia|].
        intros t Ht; induction t as [|t IH]; [lia|].
        assert (IH' : c p s (k + 1 + t) = c p s (k + 1)).
        { destruct t as [|t]; [rewrite Nat.add_0_r; reflexivity|apply IH; lia]. }
        rewrite <- IH'; apply Rle_antisym.
        - apply Rnot_lt_le; intros Hup; apply (Hno (S t)); [lia|].
          rewrite !Hsum; replace (k + S t)%nat with (k + 1 + t)%nat by lia.
          replace (k + (S t + 1))%nat with (k + 1 + S t)%nat by lia; exact Hup.
        - replace (k + 1 + S t)%nat with (k + 1 + t + 1)%nat by lia.
          apply sum_non_decreasing_sharp; assumption. }
      pose proof (Hflat (h - 1)%nat) as F1; pose proof (Hflat h) as F2.
      replace (k + 1 + (h - 1))%nat with (k + h)%nat in F1 by lia.
      replace (k + 1 + h)%nat with (k + (h + 1))%nat in F2 by lia; lra.
Qed.

(* ---- 7.8: the energy ---- *)

(* Schur's test: if |A| w <= r w then A shrinks the sum of squares by r^2. *)
Section Schur.
Variables (n : nat) (e r : R) (w x y : nat -> R).
Let M := S n.
Hypothesis Hstep : step M e x y.
Hypothesis x0 : x O = 0.
Hypothesis xM : x M = 0.
Hypothesis w0 : w O = 0.
Hypothesis wM : w M = 0.
Hypothesis wpos : forall i, (0 < i < M)%nat -> 0 < w i.
Hypothesis Hr : 0 <= r.
Hypothesis Hw : forall i, (S i < M)%nat ->
  Rabs e * w i + Rabs (1 - 2 * e) * w (S i) + Rabs e * w (S (S i)) <= r * w (S i).

(* x i = z i * w i. *)
Let z (i : nat) : R := if (Nat.ltb 0 i && Nat.ltb i M)%bool then x i / w i else 0.
Let g (i : nat) : R := w i * (z i * z i).

Let wnonneg : forall i, (i <= M)%nat -> 0 <= w i.
Proof.
  intros i Hi; destruct (Nat.eq_dec i 0) as [->|H0]; [lra|].
  destruct (Nat.eq_dec i M) as [->|H1]; [lra|]. apply Rlt_le, wpos; lia.
Qed.

Let zw : forall i, (i <= M)%nat -> x i = z i * w i.
Proof.
  intros i Hi; unfold z.
  destruct (Nat.ltb_spec 0 i); [|replace i with O by lia; simpl; lra].
  destruct (Nat.ltb_spec i M); [|replace i with M by lia; simpl; lra].
  simpl; field; apply Rgt_not_eq, wpos; lia.
Qed.

Let z0 : z O = 0.
Proof. reflexivity. Qed.

Let zM : z M = 0.
Proof. unfold z; rewrite Nat.ltb_irrefl, Bool.andb_false_r; reflexivity. Qed.

Lemma cauchy_three : forall a b d u v t, 0 <= a -> 0 <= b -> 0 <= d ->
  (a * u + b * v + d * t) * (a * u + b * v + d * t)
  <= (a + b + d) * (a * (u * u) + b * (v * v) + d * (t * t)).
Proof.
  intros a b d u v t Ha Hb Hd.
  assert (0 <= a * b * ((u - v) * (u - v))) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply Rle_0_sqr]).
  assert (0 <= a * d * ((u - t) * (u - t))) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply Rle_0_sqr]).
  assert (0 <= b * d * ((v - t) * (v - t))) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply Rle_0_sqr]).
  nra.
Qed.

Lemma schur_row : forall i, (S i < M)%nat ->
  y (S i) * y (S i) <=
  r * (w (S i) * (Rabs e * g i + Rabs (1 - 2 * e) * g (S i) + Rabs e * g (S (S i)))).
Proof.
  intros i Hi.
  pose proof (wnonneg i ltac:(lia)) as W0; pose proof (wnonneg (S i) ltac:(lia)) as W1.
  pose proof (wnonneg (S (S i)) ltac:(lia)) as W2.
  assert (Habs : forall a, exists q, (q = 1 \/ q = -1) /\ a = q * Rabs a).
  { intros a; destruct (Rle_lt_dec 0 a); [exists 1|exists (-1)]; split; auto.
    - rewrite Rabs_pos_eq by assumption; ring.
    - rewrite Rabs_left by assumption; ring. }
  destruct (Habs e) as [q [Hq Eq]]; destruct (Habs (1 - 2 * e)) as [q' [Hq' Eq']].
  rewrite (step_inner _ _ _ _ Hstep i Hi), (zw i), (zw (S i)), (zw (S (S i))) by lia.
  pose proof (cauchy_three (Rabs e * w i) (Rabs (1 - 2 * e) * w (S i)) (Rabs e * w (S (S i)))
    (q * z i) (q' * z (S i)) (q * z (S (S i)))
    ltac:(apply Rmult_le_pos; [apply Rabs_pos|exact W0])
    ltac:(apply Rmult_le_pos; [apply Rabs_pos|exact W1])
    ltac:(apply Rmult_le_pos; [apply Rabs_pos|exact W2])) as Hc.
  assert (Hqq : q * q = 1) by (destruct Hq; subst; lra).
  assert (Hqq' : q' * q' = 1) by (destruct Hq'; subst; lra).
  replace (Rabs e * w i * (q * z i) + Rabs (1 - 2 * e) * w (S i) * (q' * z (S i))
           + Rabs e * w (S (S i)) * (q * z (S (S i))))
    with (e * (z i * w i) + (1 - 2 * e) * (z (S i) * w (S i)) + e * (z (S (S i)) * w (S (S i)))) in Hc
    by (rewrite Eq at 1 3; rewrite Eq' at 1; ring).
  replace (Rabs e * w i * (q * z i * (q * z i)) + Rabs (1 - 2 * e) * w (S i) * (q' * z (S i) * (q' * z (S i)))
           + Rabs e * w (S (S i)) * (q * z (S (S i)) * (q * z (S (S i)))))
    with ((q * q) * (Rabs e * g i) + (q' * q') * (Rabs (1 - 2 * e) * g (S i)) + (q * q) * (Rabs e * g (S (S i))))
    in Hc by (unfold g; ring).
  rewrite Hqq, Hqq', !Rmult_1_l in Hc.
  eapply Rle_trans; [exact Hc|].
  assert (Hg : forall j, (j <= M)%nat -> 0 <= g j)
    by (intros j Hj; unfold g; apply Rmult_le_pos; [apply wnonneg; exact Hj|apply Rle_0_sqr]).
  rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [|apply Hw; exact Hi].
  pose proof (Hg i ltac:(lia)); pose proof (Hg (S i) ltac:(lia)); pose proof (Hg (S (S i)) ltac:(lia)).
  repeat apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto; apply Rabs_pos.
Qed.

Lemma sumn_le : forall f f' m, (forall i, (i < m)%nat -> f i <= f' i) -> sumn f m <= sumn f' m.
Proof.
  intros f f' m H; induction m as [|m IH]; simpl; [lra|].
  apply Rplus_le_compat; [apply IH; intros; apply H; lia|apply H; lia].
Qed.

Lemma schur : sumn (fun i => y (S i) * y (S i)) n <= r * r * sumn (fun i => x (S i) * x (S i)) n.
Proof.
  assert (g0 : g O = 0) by (unfold g; rewrite z0; ring).
  assert (gM : g (S n) = 0) by (unfold g; fold M; rewrite zM; ring).
  eapply Rle_trans; [apply sumn_le; intros i Hi; apply schur_row; unfold M; lia|].
  rewrite sumn_scal.
  rewrite (sumn_ext _ (fun i => (Rabs e * (w (S i) * g i) + Rabs (1 - 2 * e) * (w (S i) * g (S i)))
                                + Rabs e * (w (S i) * g (S (S i))))) by (intros; ring).
  rewrite sumn_plus, sumn_plus, !sumn_scal.
  assert (T1 : sumn (fun i => w (S i) * g i) n = sumn (fun i => w (S (S i)) * g (S i)) n).
  { pose proof (sumn_shift (fun i => w (S i) * g i) n) as H.
    change (sumn (fun i => w (S i) * g i) (S n))
      with (sumn (fun i => w (S i) * g i) n + w (S n) * g n) in H.
    fold M in H; rewrite wM, g0 in H; cbv beta in H; lra. }
  assert (T3 : sumn (fun i => w (S i) * g (S (S i))) n = sumn (fun i => w i * g (S i)) n).
  { pose proof (sumn_shift (fun i => w i * g (S i)) n) as H.
    change (sumn (fun i => w i * g (S i)) (S n))
      with (sumn (fun i => w i * g (S i)) n + w n * g (S n)) in H.
    rewrite gM, w0 in H; cbv beta in H; lra. }
  rewrite T1, T3.
  replace (r * r * sumn (fun i => x (S i) * x (S i)) n)
    with (r * (r * sumn (fun i => x (S i) * x (S i)) n)) by ring.
  apply Rmult_le_compat_l; [exact Hr|].
  rewrite <- !sumn_scal, <- !sumn_plus; apply sumn_le; intros i Hi.
  assert (Hx : x (S i) * x (S i) = w (S i) * g (S i))
    by (unfold g; rewrite (zw (S i)) by (unfold M; lia); ring).
  rewrite Hx.
  assert (Hg : 0 <= g (S i))
    by (unfold g; apply Rmult_le_pos; [apply wnonneg; unfold M; lia|apply Rle_0_sqr]).
  replace (Rabs e * (w (S (S i)) * g (S i)) + Rabs (1 - 2 * e) * (w (S i) * g (S i)) + Rabs e * (w i * g (S i)))
    with ((Rabs e * w i + Rabs (1 - 2 * e) * w (S i) + Rabs e * w (S (S i))) * g (S i)) by ring.
  rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [exact Hg|apply Hw; unfold M; lia].
Qed.
End Schur.

(* ---- On the spec ---- *)

Lemma fold_seq : forall (f : nat -> R) n, fold_left (fun sum i => sum + f i) (seq 0 n) 0 = sumn f n.
Proof.
  intros f n; induction n as [|n IH]; [reflexivity|].
  rewrite seq_S, fold_left_app, IH; reflexivity.
Qed.

Lemma energy_sumn : forall p (s : State R) k, (3 <= count (drones s))%nat -> anchored p (drones s) ->
  scaled_energy (p_min p) (p_max p) (drones (protocol_step p s k)) =
  INR (count (drones s) - 1) * INR (count (drones s) - 1)
  * sumn (fun i => error p s k (S i) * error p s k (S i)) (count (drones s) - 2).
Proof.
  intros p s k Hn Ha; set (x := drones (protocol_step p s k)).
  assert (Hc : count x = count (drones s)) by apply count_protocol_step.
  destruct (error_ends p s Hn Ha) as [E0 EM].
  unfold scaled_energy; rewrite Hc.
  set (f := fun i => INR (count (drones s) - 1) * INR (count (drones s) - 1) * (error p s k i * error p s k i)).
  assert (Hf : forall i, let err := scaled_error (p_min p) (p_max p) x i in mul err err = f i).
  { intros i; cbv zeta; rewrite scaled_error_target, Hc by (rewrite Hc; lia).
    unfold f, error; fold x; simpl; ring. }
  assert (Hfold : forall l acc, fold_left (fun sum i => let e := scaled_error (p_min p) (p_max p) x i in
                    add sum (mul e e)) l acc = fold_left (fun sum i => sum + f i) l acc).
  { induction l as [|i l IH]; intros acc; [reflexivity|].
    simpl fold_left; rewrite <- IH; f_equal; simpl; rewrite <- (Hf i); reflexivity. }
  rewrite Hfold; change (from_int (T := R) 0%Z) with 0; rewrite fold_seq.
  replace (count (drones s)) with (S (S (count (drones s) - 2))) at 1 by lia.
  set (n := (count (drones s) - 2)%nat).
  change (sumn f (S (S n))) with (sumn f (S n) + f (S n)); rewrite sumn_shift.
  assert (F0 : f O = 0) by (unfold f; rewrite E0; ring).
  assert (FM : f (S n) = 0).
  { unfold f, n; replace (S (count (drones s) - 2)) with (count (drones s) - 1)%nat by lia.
    rewrite EM; ring. }
  rewrite F0, FM; unfold f; rewrite sumn_scal; ring.
Qed.

Lemma energy_positive : forall p (s : State R) k, (3 <= count (drones s))%nat ->
  anchored p (drones s) -> ~ at_targets p (drones (protocol_step p s k)) ->
  0 < scaled_energy (p_min p) (p_max p) (drones (protocol_step p s k)).
Proof.
  intros p s k Hn Ha Hoff; rewrite energy_sumn by assumption.
  destruct (error_ends p s Hn Ha) as [E0 EM].
  assert (HM : 0 < INR (count (drones s) - 1)) by (apply INR_pos; lia).
  apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; exact HM|].
  set (f := fun i => error p s k (S i) * error p s k (S i)).
  assert (Hf : forall i, (i < count (drones s) - 2)%nat -> 0 <= f i) by (intros; apply Rle_0_sqr).
  destruct (Rle_lt_or_eq_dec 0 (sumn f (count (drones s) - 2)) (sumn_nonneg f _ Hf)) as [Hp|Hz];
    [exact Hp|exfalso; apply Hoff].
  apply at_targets_iff; rewrite count_protocol_step; [lia|]; intros i Hi.
  assert (He : error p s k i = 0).
  { destruct i as [|i]; [apply E0|].
    destruct (Nat.eq_dec (S i) (count (drones s) - 1)) as [->|Hne]; [apply EM|].
    pose proof (sumn_nonneg_zero f _ Hf (eq_sym Hz) i ltac:(lia)) as Zf; unfold f in Zf.
    apply Rmult_integral in Zf; tauto. }
  unfold error in He; lra.
Qed.

(* The energy falls by the square of the spectral radius, at least. *)
Lemma energy_shrinks : forall p (s : State R) k, (3 <= count (drones s))%nat ->
  anchored p (drones s) -> 0 <= p_eps p ->
  let r := spectral_radius (count (drones s) - 1) (p_eps p) in
  scaled_energy (p_min p) (p_max p) (drones (protocol_step p s (S k))) <=
  r * r * scaled_energy (p_min p) (p_max p) (drones (protocol_step p s k)).
Proof.
  intros p s k Hn Ha He r; rewrite !energy_sumn by assumption.
  destruct (error_ends p s Hn Ha) as [E0 EM].
  set (n := (count (drones s) - 2)%nat); set (M := (count (drones s) - 1)%nat) in *.
  assert (HM : M = S n) by (unfold M, n; lia).
  assert (HM2 : (2 <= M)%nat) by (unfold M; lia).
  match goal with |- _ <= r * r * (?a * ?b) => replace (r * r * (a * b)) with (a * (r * r * b)) by ring end.
  apply Rmult_le_compat_l; [apply Rle_0_sqr|].
  apply (schur n (p_eps p) r (wave M)); rewrite <- ?HM.
  - apply error_run; assumption.
  - apply E0.
  - apply EM.
  - apply wave_first.
  - apply wave_last; exact HM2.
  - intros i Hi; apply wave_pos; assumption.
  - eapply Rle_trans; [apply Rabs_pos|apply Rmax_l].
  - intros i Hi; apply wave_contracts; assumption.
Qed.

Lemma energy_falls : forall p (s : State R) k, (3 <= count (drones s))%nat ->
  anchored p (drones s) -> 0 < p_eps p < critical_weight (count (drones s)) ->
  ~ at_targets p (drones (protocol_step p s k)) ->
  scaled_energy (p_min p) (p_max p) (drones (protocol_step p s (S k))) <
  scaled_energy (p_min p) (p_max p) (drones (protocol_step p s k)).
Proof.
  intros p s k Hn Ha He Hoff.
  pose proof (energy_positive p s k Hn Ha Hoff) as Hp.
  pose proof (energy_shrinks p s k Hn Ha ltac:(lra)) as Hs; cbv zeta in Hs.
  pose proof (spectral_radius_below_one (count (drones s) - 1) ltac:(lia) (p_eps p)) as Hr.
  replace (count (drones s) - 1 + 1)%nat with (count (drones s)) in Hr by lia.
  specialize (Hr He); set (r := spectral_radius (count (drones s) - 1) (p_eps p)) in *.
  assert (r * r < 1) by nra.
  eapply Rle_lt_trans; [exact Hs|].
  rewrite <- (Rmult_1_l (scaled_energy _ _ (drones (protocol_step p s k)))) at 2.
  apply Rmult_lt_compat_r; assumption.
Qed.

Lemma energy_along : forall p (s : State R) lambda, (3 <= count (drones s))%nat ->
  anchored p (drones s) ->
  (forall k i, (i <= count (drones s) - 1)%nat -> error p s k i = lambda ^ k * error p s 0 i) ->
  scaled_energy (p_min p) (p_max p) (drones (protocol_step p s 1)) =
  lambda * lambda * scaled_energy (p_min p) (p_max p) (drones (protocol_step p s 0)).
Proof.
  intros p s lambda Hn Ha Hl; rewrite !energy_sumn by assumption.
  rewrite (sumn_ext _ (fun i => lambda * lambda * (error p s 0 (S i) * error p s 0 (S i)))).
  - rewrite sumn_scal; ring.
  - intros i Hi; rewrite (Hl 1%nat) by lia; ring.
Qed.

(* The finite form of 7.8: the energy falls in every step off the targets, from
   every anchored start, exactly for the weights for which every anchored start
   converges (limit_iff). *)
Theorem limit_finite : forall p N, (3 <= N)%nat ->
  ((forall s : State R, count (drones s) = N -> anchored p (drones s) ->
      forall k, conclusion Paper Limit p (from_step p s k))
   <-> 0 < p_eps p < critical_weight N).
Proof.
  intros p N HN; assert (HM : (2 <= N - 1)%nat) by lia; split.
  - intros H; pose proof (cos_theta_range (N - 1) HM) as Hcos.
    destruct (limit_exact_rate_attained p N HN) as
      [[s1 [C1 [A1 [P1 R1]]]] [s2 [C2 [A2 [P2 R2]]]]].
    assert (Hlambda : forall (s : State R) lambda, count (drones s) = N -> anchored p (drones s) ->
      error p s 0 1 <> 0 ->
      (forall k i, (i <= N - 1)%nat -> error p s k i = lambda ^ k * error p s 0 i) ->
      lambda * lambda < 1).
    { intros s lambda Hc Ha H1 Hl.
      assert (Hoff : ~ at_targets p (drones (protocol_step p s 0))).
      { intros Ht; apply H1; unfold error.
        rewrite (proj1 (at_targets_iff p (drones (protocol_step p s 0))
          ltac:(rewrite count_protocol_step; lia)) Ht 1%nat)
          by (rewrite count_protocol_step; lia).
        rewrite count_protocol_step; ring. }
      pose proof (energy_positive p s 0 ltac:(lia) Ha Hoff) as Hp.
      destruct (H s Hc Ha 0%nat) as [Hfall _]; [exact Hoff|].
      change (scaled_energy (p_min p) (p_max p) (drones (protocol_step p s 1)) <
              scaled_energy (p_min p) (p_max p) (drones (protocol_step p s 0))) in Hfall.
      rewrite (energy_along p s lambda) in Hfall by (rewrite ?Hc; auto; lia).
      apply Rnot_le_lt; intros Hge.
      assert (1 * scaled_energy (p_min p) (p_max p) (drones (protocol_step p s 0))
              <= lambda * lambda * scaled_energy (p_min p) (p_max p) (drones (protocol_step p s 0)))
        by (apply Rmult_le_compat_r; lra).
      lra. }
    pose proof (Hlambda s1 _ C1 A1 ltac:(lra) R1) as L1.
    pose proof (Hlambda s2 _ C2 A2 ltac:(lra) R2) as L2.
    unfold largest_eigenvalue in L1; unfold least_eigenvalue in L2.
    split.
    + apply Rnot_le_lt; intros Hbad.
      assert (0 <= - p_eps p * (1 - cos (theta (N - 1)))) by (apply Rmult_le_pos; lra). nra.
    + replace N with (N - 1 + 1)%nat by lia; apply below_critical_iff; [exact HM|].
      apply Rnot_le_lt; intros Hbad.
      assert (1 - 2 * p_eps p * (1 + cos (theta (N - 1))) <= -1) by lra. nra.
  - intros He s Hc Ha k Hoff; split; [|exact I].
    unfold from_step in *; rewrite Nat.add_0_r in *; rewrite Nat.add_1_r.
    apply energy_falls; rewrite ?Hc; auto.
Qed.

(* ---- The rate in one step ---- *)

Lemma magnitude_Rabs : forall e : R, magnitude e (Rabs e).
Proof.
  intros e; unfold magnitude; simpl.
  destruct (Rlt_le_dec e 0) as [H|H]; [left|right]; split; auto.
  - rewrite Rabs_left by exact H; ring.
  - apply Rabs_pos_eq; exact H.
Qed.

(* Among the internal drones one has the largest |e_j| / w_j. *)
Lemma largest_ratio : forall (E w : nat -> R) n, (forall i, (i < S n)%nat -> 0 < w i) ->
  exists j, (j < S n)%nat /\ forall i, (i < S n)%nat -> Rabs (E i) * w j <= Rabs (E j) * w i.
Proof.
  intros E w n; induction n as [|n IH]; intros Hw.
  - exists O; split; [lia|]; intros i Hi; replace i with O by lia; lra.
  - destruct IH as [j [Hj Hmax]]; [intros i Hi; apply Hw; lia|].
    pose proof (Hw j ltac:(lia)) as Wj; pose proof (Hw (S n) ltac:(lia)) as Wn.
    destruct (Rle_lt_dec (Rabs (E (S n)) * w j) (Rabs (E j) * w (S n))) as [Hle|Hgt].
    + exists j; split; [lia|]; intros i Hi.
      destruct (Nat.eq_dec i (S n)) as [->|Hne]; [exact Hle|apply Hmax; lia].
    + exists (S n); split; [lia|]; intros i Hi.
      destruct (Nat.eq_dec i (S n)) as [->|Hne]; [lra|].
      specialize (Hmax i ltac:(lia)); pose proof (Hw i ltac:(lia)) as Wi.
      apply Rmult_le_reg_r with (w j); [exact Wj|].
      assert (Rabs (E i) * w j * w (S n) <= Rabs (E j) * w i * w (S n))
        by (apply Rmult_le_compat_r; lra).
      assert (Rabs (E j) * w (S n) * w i <= Rabs (E (S n)) * w j * w i)
        by (apply Rmult_le_compat_r; lra).
      lra.
Qed.

Lemma rate_in_one_step : forall p (s : State R) k, (3 <= count (drones s))%nat ->
  anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  at_rate p (drones (protocol_step p s k)) (drones (protocol_step p s (S k))).
Proof.
  intros p s k Hn Ha He; unfold at_rate; cbv zeta; intros _ i Hi.
  rewrite count_protocol_step in *.
  destruct (error_ends p s Hn Ha) as [E0 EM].
  set (N := count (drones s)) in *; set (M := (N - 1)%nat) in *.
  assert (HMpos : 0 < INR M) by (apply INR_pos; unfold M; lia).
  assert (Hscaled : forall k' j, scaled_error (p_min p) (p_max p) (drones (protocol_step p s k')) j
                                 = INR M * error p s k' j).
  { intros k' j; rewrite scaled_error_target, count_protocol_step by (rewrite count_protocol_step; lia).
    reflexivity. }
  destruct (largest_ratio (fun j => error p s k (S j)) (fun j => weight M (S j)) (M - 2))
    as [j [Hj Hmax]].
  { intros l Hl; apply weight_pos; unfold M in *; lia. }
  set (C := Rabs (error p s k (S j)) / weight M (S j)).
  assert (Wj : 0 < weight M (S j)) by (apply weight_pos; unfold M in *; lia).
  assert (HC : 0 <= C)
    by (unfold C; apply Rmult_le_pos; [apply Rabs_pos|apply Rlt_le, Rinv_0_lt_compat; exact Wj]).
  assert (W0 : weight M 0 = 0) by (unfold weight; simpl; ring).
  assert (WM : weight M M = 0) by (unfold weight; rewrite Nat.sub_diag; simpl; ring).
  assert (Hbound : forall l, (l <= M)%nat -> Rabs (error p s k l) <= C * weight M l).
  { intros l Hl; destruct l as [|l]; [rewrite E0, Rabs_R0, W0; lra|].
    destruct (Nat.eq_dec (S l) M) as [E|E]; [rewrite E, EM, Rabs_R0, WM; lra|].
    apply Rmult_le_reg_r with (weight M (S j)); [exact Wj|].
    replace (C * weight M (S l) * weight M (S j)) with (Rabs (error p s k (S j)) * weight M (S l))
      by (unfold C; field; lra).
    apply Hmax; unfold M in *; lia. }
  pose proof (contraction_step M (p_eps p) (rate M (p_eps p)) (weight M) C (error p s k) (error p s (S k))
    (error_run p s Hn Ha k) HC (E0 k) (EM k) ltac:(lra) ltac:(lra)
    (proj1 (rate_range M (p_eps p) ltac:(unfold M; lia) He))
    (fun l Hl => weight_contracts M (p_eps p) l ltac:(lra) Hl) Hbound i ltac:(unfold M in *; lia)) as Hstep.
  exists (S j), (Rabs (INR M * error p s (S k) i)), (Rabs (INR M * error p s k (S j))).
  rewrite !Hscaled; split; [unfold M in *; lia|].
  split; [apply magnitude_Rabs|split; [apply magnitude_Rabs|]].
  rewrite !from_index_INR, <- !weight_contraction_weight; fold M.
  change (at_most (T := R)) with Rle; change (mul (T := R)) with Rmult; change (sub (T := R)) with Rminus.
  change (from_int (T := R) 1%Z) with 1; change (from_int (T := R) 8%Z) with 8.
  rewrite !Rabs_mult, (Rabs_pos_eq (INR M)) by lra.
  assert (Hkept : INR M * INR M * 1 - 8 * p_eps p = INR M * INR M * rate M (p_eps p))
    by (unfold rate; field; lra).
  rewrite Hkept.
  assert (Hw : Rabs (error p s (S k) i) * weight M (S j)
               <= rate M (p_eps p) * Rabs (error p s k (S j)) * weight M i).
  { replace (rate M (p_eps p) * Rabs (error p s k (S j)) * weight M i)
      with (rate M (p_eps p) * C * weight M i * weight M (S j)) by (unfold C; field; lra).
    apply Rmult_le_compat_r; lra. }
  replace (INR M * INR M * 1 * (INR M * Rabs (error p s (S k) i)) * weight M (S j))
    with (INR M * INR M * INR M * (Rabs (error p s (S k) i) * weight M (S j))) by ring.
  replace (INR M * INR M * rate M (p_eps p) * (INR M * Rabs (error p s k (S j))) * weight M i)
    with (INR M * INR M * INR M * (rate M (p_eps p) * Rabs (error p s k (S j)) * weight M i)) by ring.
  apply Rmult_le_compat_l; [|exact Hw].
  apply Rlt_le; repeat apply Rmult_lt_0_compat; exact HMpos.
Qed.

(* ---- The sharp forms hold, as the Rust states them ---- *)

Lemma below_critical_range : forall p N, (3 <= N)%nat ->
  (in_range BelowCritical (p_eps p) (from_int (T := R) 1%Z) N <-> 0 < p_eps p < critical_weight N).
Proof.
  intros p N HN; unfold in_range; change (less (T := R)) with Rlt.
  change (from_int (T := R) 0%Z) with 0; change (from_int (T := R) 1%Z) with 1.
  assert (Hb : 0 < p_eps p -> (below_critical (p_eps p) 1 N <-> p_eps p < critical_weight N)).
  { intros H0; rewrite (below_critical_correct (p_eps p) 1 N HN H0 Rlt_0_1).
    unfold Rdiv; rewrite Rinv_1, Rmult_1_r; apply iff_refl. }
  split; intros [H0 H1]; split; auto; apply (Hb H0); exact H1.
Qed.

Theorem sharp_conclusions : forall th p (s : State R),
  (3 <= count (drones s))%nat -> met_by Sharp th p (drones s) ->
  forall k, conclusion Sharp th p (from_step p s k).
Proof.
  intros th p s Hn [Hrange [Ha Hset]] k; set (N := count (drones s)) in *.
  assert (HN : forall h, count (from_step p s k h) = N) by (intros; apply count_from_step).
  assert (Hnow : from_step p s k 0 = drones (protocol_step p s k))
    by (unfold from_step; rewrite Nat.add_0_r; reflexivity).
  assert (Hnext : from_step p s k 1 = drones (protocol_step p s (k + 1))) by reflexivity.
  unfold conclusion; cbv zeta; rewrite Hnow, ?Hnext, ?count_protocol_step; fold N.
  destruct th; cbn [hypothesis fst snd] in Hrange, Hset; cbn [in_range] in Hrange;
    change (at_most (T := R)) with Rle in *; change (less (T := R)) with Rlt in *;
    change (mul (T := R)) with Rmult in *; change (from_int (T := R) 0%Z) with 0 in *;
    change (from_int (T := R) 1%Z) with 1 in *; change (from_int (T := R) 2%Z) with 2 in *.
  - destruct Hrange as [H0 H1]; destruct (Nat.eqb_spec N 3).
    + apply ordering_three; auto.
    + apply ordering_sharp; auto; lra.
  - apply upper_bound_sharp; auto; lra.
  - unfold doubled; cbn [fst snd]; rewrite from_index_INR, count_protocol_step; fold N.
    change (mul (T := R)) with Rmult; change (add (T := R)) with Rplus.
    change (from_int (T := R) 2%Z) with 2; rewrite <- sum_bound_doubled by lia.
    apply Rmult_le_compat_l; [lra|]; apply sum_bounded_sharp; auto; lra.
  - unfold doubled; cbn [fst snd]; rewrite from_index_INR, count_protocol_step; fold N.
    change (mul (T := R)) with Rmult; change (add (T := R)) with Rplus.
    change (from_int (T := R) 2%Z) with 2; rewrite <- sum_bound_doubled by lia.
    rewrite <- (sum_maximal_sharp p s Hn Ha ltac:(lra) Hset k); fold N; split; intros E; lra.
  - apply sum_non_decreasing_sharp; auto; lra.
  - intros Ht; symmetry; apply sum_stationary_sharp; auto.
  - intros Ht h _; unfold from_step; rewrite targets_fixed_sharp; auto.
  - intros Hall; apply constant_sum_bounded; auto; [lra|]; fold N.
    intros h Hh; symmetry; apply (Hall h); cbn [span]; rewrite Nat.max_l by lia; exact Hh.
  - intros step [[j [Hj [Hoff Hd]]] Hleast]; rewrite count_protocol_step in *; fold N in Hj, Hd, Hleast.
    fold (depth N j) in Hd.
    pose proof (off_target_internal p s k j Hn Ha Hj Hoff) as Hdeep; fold N in Hdeep.
    destruct step as [|h]; [lia|].
    destruct (increasing_sharp p s Hn Ha ltac:(lra) Hset k h j) as [Hstay Hup].
    + split; assumption.
    + exact Hd.
    + intros i [Hi Pi]; apply Hleast; assumption.
    + split.
      * intros t Ht; symmetry; apply Hstay; lia.
      * change (c p s k < c p s (k + S h)); rewrite <- (Hstay h (le_n h)).
        replace (k + S h)%nat with (k + h + 1)%nat by lia; exact Hup.
  - intros Hoff; apply below_critical_range in Hrange; [|exact Hn].
    rewrite Nat.add_1_r; split; [apply energy_falls; assumption|].
    unfold at_rate; cbv zeta; intros Hrate.
    apply rate_in_one_step; auto.
    cbn [in_range] in Hrate; destruct Hrate as [H0 H1].
    change (at_most (T := R)) with Rle in H1; change (mul (T := R)) with Rmult in H1.
    change (from_int (T := R) 2%Z) with 2 in H1; change (from_int (T := R) 1%Z) with 1 in H1; lra.
Qed.

(* And the printed forms, but for the three that are false for some weight that
   they allow. *)
Theorem paper_conclusions : forall th p (s : State R),
  (3 <= count (drones s))%nat -> p_min p < p_max p ->
  ~ In th (ConstantSum :: GloballyIncreasing :: Limit :: nil) -> met_by Paper th p (drones s) ->
  forall k, conclusion Paper th p (from_step p s k).
Proof.
  intros th p s Hn Hseg Hth [Hrange [Ha Hset]] k; set (N := count (drones s)) in *.
  assert (Hnow : from_step p s k 0 = drones (protocol_step p s k))
    by (unfold from_step; rewrite Nat.add_0_r; reflexivity).
  assert (Hnext : from_step p s k 1 = drones (protocol_step p s (k + 1))) by reflexivity.
  unfold conclusion; cbv zeta; rewrite Hnow, ?Hnext, ?count_protocol_step; fold N.
  destruct th; cbn [hypothesis fst snd] in Hrange, Hset; cbn [in_range] in Hrange;
    try (exfalso; apply Hth; simpl; tauto);
    change (at_most (T := R)) with Rle in *; change (less (T := R)) with Rlt in *;
    change (mul (T := R)) with Rmult in *; change (from_int (T := R) 0%Z) with 0 in *;
    change (from_int (T := R) 1%Z) with 1 in *; change (from_int (T := R) 2%Z) with 2 in *;
    change (from_int (T := R) 3%Z) with 3 in *.
  - apply ordering_sharp; auto; lra.
  - apply upper_bound_sharp; auto; [lra|]; destruct Hset.
    apply first_subsegment_upper_bounded; auto; lra.
  - unfold doubled; cbn [fst snd]; rewrite from_index_INR, count_protocol_step; fold N.
    change (mul (T := R)) with Rmult; change (add (T := R)) with Rplus.
    change (from_int (T := R) 2%Z) with 2; rewrite <- sum_bound_doubled by lia.
    apply Rmult_le_compat_l; [lra|]; destruct Hset; apply sum_paper; auto; lra.
  - unfold doubled; cbn [fst snd]; rewrite from_index_INR, count_protocol_step; fold N.
    change (mul (T := R)) with Rmult; change (add (T := R)) with Rplus.
    change (from_int (T := R) 2%Z) with 2; rewrite <- sum_bound_doubled by lia.
    pose proof (proj2 (sum_paper p s Hn Hseg Ha ltac:(lra) (proj2 Hset) k)) as E; fold N in E.
    rewrite <- E; split; intros Q; lra.
  - destruct Hset; apply sum_non_decreasing_paper; auto; lra.
  - intros Ht; symmetry; apply sum_stationary_sharp; auto.
  - intros Ht h _; unfold from_step; rewrite targets_fixed_sharp; auto.
Qed.

(* ---- Not for delays, not for activation schedules ---- *)

(* Four drones with opposite errors: equal sums over N-2 = 2 steps, and then
   another, when drone 1 sees an old drone 2, or when drone 2 rests. *)
Definition opposite_params : Params Q := mkParams 0%Q 3%Q (1 # 4)%Q 0.

Definition opposite_start : State Q := mkState (0 :: (1 # 2) :: (5 # 2) :: 3 :: nil)%Q 0.

Definition late_delay (k i j : nat) : nat := if ((k =? 2) && (i =? 1))%nat%bool then 2 else 0.

Definition resting (k i : nat) : bool := negb ((k =? 2) && (i =? 2))%nat.

Theorem equal_sums_delayed_fails :
  let c k := sum (drones (delayed_step opposite_params late_delay opposite_start k)) in
  c 1%nat = c 0%nat /\ c 2%nat = c 0%nat /\ c 3%nat <> c 0%nat.
Proof. cbv zeta; split; [|split]; vm_compute; [reflexivity|reflexivity|discriminate]. Qed.

Theorem equal_sums_active_fails :
  let c k := sum (drones (active_step opposite_params resting opposite_start k)) in
  c 1%nat = c 0%nat /\ c 2%nat = c 0%nat /\ c 3%nat <> c 0%nat.
Proof. cbv zeta; split; [|split]; vm_compute; [reflexivity|reflexivity|discriminate]. Qed.
