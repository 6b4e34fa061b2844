(** The rules of the certificate checker's kernel (proofs/checker/src/kernel/) are sound: what they
    derive is true. Clauses are embedded deeply, polynomials as the functions of a valuation
    that they denote; two polynomials that are equal as polynomials denote the same function. *)

From Coq Require Import Reals List Lra Lia ZArith FunctionalExtensionality.
Import ListNotations.
Open Scope R_scope.

(** Variables are numbered; [sort v] says which take integer values. *)
Definition valuation := nat -> R.
Definition poly := valuation -> R.

Inductive relation := Gt | Ge | Eq.

Definition literal := (poly * relation)%type.

Definition holds (rho : valuation) (l : literal) : Prop :=
  match snd l with
  | Gt => fst l rho > 0
  | Ge => fst l rho >= 0
  | Eq => fst l rho = 0
  end.

Record clause := { given : list literal; goal : literal }.

Section Kernel.

Variable sort : nat -> bool.

Definition sorted (rho : valuation) : Prop :=
  forall v, sort v = true -> exists z, rho v = IZR z.

Definition update (rho : valuation) (v : nat) (x : R) : valuation :=
  fun u => if Nat.eq_dec u v then x else rho u.

Definition at_poly (v : nat) (p : poly) (l : literal) : literal :=
  (fun rho => fst l (update rho v (p rho)), snd l).

Definition instance (s : nat -> poly) (l : literal) : literal :=
  (fun rho => fst l (fun v => s v rho), snd l).

Definition integer (p : poly) : Prop :=
  forall rho, sorted rho -> exists z, p rho = IZR z.

(** Variables that inductions around hold fixed. *)
Definition agree (fixed : nat -> Prop) (rho rho' : valuation) : Prop :=
  forall v, fixed v -> rho v = rho' v.

Definition true_at (fixed : nat -> Prop) (rho : valuation) (c : clause) : Prop :=
  forall rho', sorted rho' -> agree fixed rho rho' ->
    (forall l, In l (given c) -> holds rho' l) -> holds rho' (goal c).

Definition product (fs : list literal) : poly :=
  fun rho => fold_right (fun l x => fst l rho * x) 1 fs.

(** A term of a sum: any polynomial times facts, one of them zero; or a positive number times facts. *)
Definition term := (poly * list literal)%type.

Definition sum (ts : list term) : poly :=
  fun rho => fold_right (fun t x => fst t rho * product (snd t) rho + x) 0 ts.

Definition zero (t : term) : Prop := exists l, In l (snd t) /\ snd l = Eq.

Definition positive (t : term) : Prop := exists c, c > 0 /\ forall rho, fst t rho = c.

Definition minus (p : poly) : poly := fun rho => - p rho.
Definition var (v : nat) : poly := fun rho => rho v.
Definition less (p : poly) (n : R) : poly := fun rho => p rho - n.

Inductive derives : list clause -> (nat -> Prop) -> list literal -> literal -> Prop :=
| d_given H fixed gs l : In l gs -> derives H fixed gs l
(** positivity *)
| d_sum H fixed gs times ts g :
    (forall l, In l times -> snd l = Gt) ->
    (forall l, In l times -> derives H fixed gs l) ->
    (forall t l, In t ts -> In l (snd t) -> derives H fixed gs l) ->
    (forall t, In t ts -> zero t \/ (snd g <> Eq /\ positive t)) ->
    (snd g = Gt -> exists t, In t ts /\ positive t /\ forall l, In l (snd t) -> snd l = Gt) ->
    (forall rho, sorted rho -> product times rho * fst g rho = sum ts rho) ->
    derives H fixed gs g
(** an instance of a lemma or of a hypothesis *)
| d_instance H (fixed : nat -> Prop) gs h s :
    In h H ->
    (forall v, sort v = true -> integer (s v)) ->
    (forall v, fixed v -> forall rho, s v rho = rho v) ->
    (forall l, In l (given h) -> derives H fixed gs (instance s l)) ->
    derives H fixed gs (instance s (goal h))
(** absurd *)
| d_absurd H fixed gs g :
    derives H fixed gs (fun _ => -1, Ge) -> derives H fixed gs g
(** cases, from below and from above *)
| d_cases_below H fixed gs g v b :
    sort v = true -> ~ fixed v -> integer b ->
    In ((fun rho => rho v - b rho), Ge) gs ->
    derives H fixed (map (at_poly v b) gs) (at_poly v b g) ->
    derives H fixed (((fun rho => rho v - b rho - 1), Ge) :: gs) g ->
    derives H fixed gs g
| d_cases_above H fixed gs g v b :
    sort v = true -> ~ fixed v -> integer b ->
    In ((fun rho => b rho - rho v), Ge) gs ->
    derives H fixed (map (at_poly v b) gs) (at_poly v b g) ->
    derives H fixed (((fun rho => b rho - rho v - 1), Ge) :: gs) g ->
    derives H fixed gs g
(** split *)
| d_split H fixed gs g p :
    derives H fixed ((p, Gt) :: gs) g ->
    derives H fixed ((p, Eq) :: gs) g ->
    derives H fixed ((minus p, Gt) :: gs) g ->
    derives H fixed gs g
| d_split_integer H fixed gs g p :
    integer p ->
    derives H fixed ((less p 1, Ge) :: gs) g ->
    derives H fixed ((p, Eq) :: gs) g ->
    derives H fixed ((less (minus p) 1, Ge) :: gs) g ->
    derives H fixed gs g
(** induction: t stands for the variable in the hypothesis *)
| d_induction H fixed gs g v t b :
    sort v = true -> sort t = true -> ~ fixed v -> integer b ->
    (forall rho rho', agree fixed rho rho' -> b rho = b rho') ->
    In ((fun rho => rho v - b rho), Ge) gs ->
    derives H fixed (map (at_poly v b) gs) (at_poly v b g) ->
    derives
      ({| given := ((fun rho => rho v - rho t), Ge) :: map (at_poly v (var t)) gs;
          goal := at_poly v (var t) g |} :: H)
      (fun u => fixed u \/ u = v)
      (((fun rho => rho v - b rho), Ge) :: map (at_poly v (fun rho => rho v + 1)) gs)
      (at_poly v (fun rho => rho v + 1) g) ->
    derives H fixed gs g.

Lemma update_same rho v : update rho v (rho v) = rho.
Proof.
  extensionality u. unfold update. destruct (Nat.eq_dec u v); congruence.
Qed.

Lemma update_value rho v x : update rho v x v = x.
Proof. unfold update. destruct (Nat.eq_dec v v); congruence. Qed.

Lemma update_twice rho v x y : update (update rho v x) v y = update rho v y.
Proof. extensionality u. unfold update. destruct (Nat.eq_dec u v); reflexivity. Qed.

Lemma update_sorted rho v z : sorted rho -> sorted (update rho v (IZR z)).
Proof.
  intros S u U. unfold update. destruct (Nat.eq_dec u v); [exists z; reflexivity | apply S, U].
Qed.

Lemma update_agree (fixed : nat -> Prop) rho v x : ~ fixed v -> agree fixed rho (update rho v x).
Proof.
  intros N u F. unfold update. destruct (Nat.eq_dec u v) as [-> |]; [contradiction | reflexivity].
Qed.

Lemma product_cons rho l fs : product (l :: fs) rho = fst l rho * product fs rho.
Proof. reflexivity. Qed.

Lemma sum_cons rho t ts : sum (t :: ts) rho = fst t rho * product (snd t) rho + sum ts rho.
Proof. reflexivity. Qed.

Lemma product_sign rho fs :
  (forall l, In l fs -> holds rho l) ->
  ((exists l, In l fs /\ snd l = Eq) -> product fs rho = 0) /\
  (product fs rho >= 0 \/ exists l, In l fs /\ snd l = Eq) /\
  ((forall l, In l fs -> snd l = Gt) -> product fs rho > 0).
Proof.
  induction fs as [| l fs IH]; intros A.
  - repeat split.
    + intros (l & [] & _).
    + left. unfold product. simpl. lra.
    + unfold product. simpl. lra.
  - destruct IH as (Z & N & P). { intros k K. apply A. right. exact K. }
    pose proof (A l (or_introl eq_refl)) as L. unfold holds in L. repeat split.
    + intros (k & [<- | K] & E).
      * rewrite E in L. rewrite product_cons, L. ring.
      * rewrite product_cons, Z by (exists k; auto). ring.
    + destruct (snd l) eqn:E.
      * destruct N as [N | (k & K & F)]; [left; rewrite product_cons | right; exists k; split; [right |]; assumption].
        apply Rle_ge, Rmult_le_pos; lra.
      * destruct N as [N | (k & K & F)]; [left; rewrite product_cons | right; exists k; split; [right |]; assumption].
        apply Rle_ge, Rmult_le_pos; lra.
      * right. exists l. split; [left; reflexivity | exact E].
    + intros G. rewrite product_cons. rewrite (G l (or_introl eq_refl)) in L.
      apply Rmult_gt_0_compat; [exact L |]. apply P. intros k K. apply G. right. exact K.
Qed.

Lemma sum_zero rho ts :
  (forall t, In t ts -> (forall l, In l (snd t) -> holds rho l) /\ zero t) -> sum ts rho = 0.
Proof.
  induction ts as [| t ts IH]; intros A; [reflexivity |].
  rewrite sum_cons, IH by (intros u U; apply A; right; exact U).
  destruct (A t (or_introl eq_refl)) as (L & Z).
  rewrite (proj1 (product_sign rho (snd t) L) Z). ring.
Qed.

Lemma term_nonnegative rho t :
  (forall l, In l (snd t) -> holds rho l) -> zero t \/ positive t ->
  fst t rho * product (snd t) rho >= 0.
Proof.
  intros L [Z | (c & C & E)]; destruct (product_sign rho (snd t) L) as (P & N & _).
  - rewrite (P Z). lra.
  - rewrite E. destruct N as [N | Z]; [| rewrite (P Z); lra].
    apply Rle_ge, Rmult_le_pos; lra.
Qed.

Lemma sum_nonnegative rho ts :
  (forall t, In t ts -> (forall l, In l (snd t) -> holds rho l) /\ (zero t \/ positive t)) ->
  sum ts rho >= 0 /\
  ((exists t, In t ts /\ positive t /\ forall l, In l (snd t) -> snd l = Gt) -> sum ts rho > 0).
Proof.
  induction ts as [| t ts IH]; intros A.
  - split; [unfold sum; simpl; lra | intros (t & [] & _)].
  - destruct IH as (N & P). { intros u U. apply A. right. exact U. }
    destruct (A t (or_introl eq_refl)) as (L & Z).
    pose proof (term_nonnegative rho t L Z) as T. rewrite sum_cons. split; [lra |].
    intros (u & [<- | U] & (c & C & E) & G).
    + pose proof (proj2 (proj2 (product_sign rho (snd t) L)) G) as Q.
      rewrite E in *. pose proof (Rmult_gt_0_compat c _ C Q). lra.
    + assert (sum ts rho > 0) by (apply P; exists u; repeat split; [exact U | exists c; auto | exact G]). lra.
Qed.

Lemma holds_at rho v p l : holds rho (at_poly v p l) = holds (update rho v (p rho)) l.
Proof. reflexivity. Qed.

Lemma given_at rho v p gs x :
  p rho = x -> (forall l, In l gs -> holds (update rho v x) l) ->
  forall l, In l (map (at_poly v p) gs) -> holds rho l.
Proof.
  intros <- A l I. apply in_map_iff in I. destruct I as (k & <- & K). apply (A k K).
Qed.

Theorem sound H fixed gs g :
  derives H fixed gs g ->
  forall rho, sorted rho -> (forall h, In h H -> true_at fixed rho h) ->
  (forall l, In l gs -> holds rho l) -> holds rho g.
Proof.
  induction 1 as
    [ H fixed gs l I
    | H fixed gs times ts g Tg Td IHt Sd IHs Sok Str E
    | H fixed gs h s I Int Fix Dg IHg
    | H fixed gs g D IH
    | H fixed gs g v b S F B I D1 IH1 D2 IH2
    | H fixed gs g v b S F B I D1 IH1 D2 IH2
    | H fixed gs g p D1 IH1 D2 IH2 D3 IH3
    | H fixed gs g p Int D1 IH1 D2 IH2 D3 IH3
    | H fixed gs g v t b S St F B Bf I D1 IH1 D2 IH2 ]; intros rho W K A.
  - exact (A l I).
  - (* positivity *)
    assert (T : forall l, In l times -> holds rho l) by (intros l L; apply IHt; assumption).
    assert (Q : forall t, In t ts -> forall l, In l (snd t) -> holds rho l)
      by (intros t U l L; apply (IHs t l U L); assumption).
    pose proof (proj2 (proj2 (product_sign rho times T)) Tg) as P.
    pose proof (E rho W) as X.
    destruct g as (p, r). unfold holds. simpl in *. destruct r.
    + assert (Y : sum ts rho > 0).
      { apply (sum_nonnegative rho ts); [| apply Str; reflexivity].
        intros t U. split; [exact (Q t U) | destruct (Sok t U) as [Z | (_ & Z)]; auto]. }
      rewrite <- X in Y. destruct (Rle_or_lt (p rho) 0) as [L | L]; [| exact L].
      exfalso. assert (product times rho * p rho <= 0); [| lra].
      rewrite <- (Rmult_0_r (product times rho)). apply Rmult_le_compat_l; lra.
    + assert (Y : sum ts rho >= 0).
      { apply (sum_nonnegative rho ts).
        intros t U. split; [exact (Q t U) | destruct (Sok t U) as [Z | (_ & Z)]; auto]. }
      rewrite <- X in Y. destruct (Rlt_or_le (p rho) 0) as [L | L]; [| lra].
      exfalso. assert (product times rho * p rho < 0); [| lra].
      rewrite <- (Rmult_0_r (product times rho)). apply Rmult_lt_compat_l; lra.
    + assert (Y : sum ts rho = 0).
      { apply sum_zero. intros t U. split; [exact (Q t U) |].
        destruct (Sok t U) as [Z | (Z & _)]; [exact Z | contradiction Z; reflexivity]. }
      rewrite Y in X. apply Rmult_integral in X. destruct X; [lra | assumption].
  - (* instance *)
    apply (K h I (fun v => s v rho)).
    + intros v V. exact (Int v V rho W).
    + intros v V. rewrite (Fix v V). reflexivity.
    + intros l L. exact (IHg l L rho W K A).
  - (* absurd *)
    pose proof (IH rho W K A) as X. unfold holds in X. simpl in X. lra.
  - (* cases from below *)
    pose proof (A _ I) as X. unfold holds in X. simpl in X.
    destruct (W v S) as (z, Z). destruct (B rho W) as (n, N). rewrite Z, N in X.
    apply Rge_le in X. assert (n <= z)%Z by (apply le_IZR; lra).
    destruct (Z.eq_dec n z) as [<- | M].
    + assert (U : update rho v (b rho) = rho) by (rewrite N, <- Z; apply update_same).
      rewrite <- U. apply (IH1 rho W K). apply (given_at rho v b gs _ eq_refl).
      rewrite U. exact A.
    + apply (IH2 rho W K). intros l [<- | L]; [| exact (A l L)].
      unfold holds. simpl. rewrite Z, N.
      assert (n + 1 <= z)%Z as Y by lia. apply IZR_le in Y. rewrite plus_IZR in Y. lra.
  - (* cases from above *)
    pose proof (A _ I) as X. unfold holds in X. simpl in X.
    destruct (W v S) as (z, Z). destruct (B rho W) as (n, N). rewrite Z, N in X.
    apply Rge_le in X. assert (z <= n)%Z by (apply le_IZR; lra).
    destruct (Z.eq_dec n z) as [<- | M].
    + assert (U : update rho v (b rho) = rho) by (rewrite N, <- Z; apply update_same).
      rewrite <- U. apply (IH1 rho W K). apply (given_at rho v b gs _ eq_refl).
      rewrite U. exact A.
    + apply (IH2 rho W K). intros l [<- | L]; [| exact (A l L)].
      unfold holds. simpl. rewrite Z, N.
      assert (z + 1 <= n)%Z as Y by lia. apply IZR_le in Y. rewrite plus_IZR in Y. lra.
  - (* split of a real *)
    destruct (Rtotal_order (p rho) 0) as [L | [L | L]].
    + apply (IH3 rho W K). intros l [<- | M]; [unfold holds, minus; simpl; lra | exact (A l M)].
    + apply (IH2 rho W K). intros l [<- | M]; [exact L | exact (A l M)].
    + apply (IH1 rho W K). intros l [<- | M]; [exact L | exact (A l M)].
  - (* split of an integer *)
    destruct (Int rho W) as (z, Z).
    destruct (Z.lt_total z 0) as [L | [L | L]].
    + apply (IH3 rho W K). intros l [<- | M]; [| exact (A l M)].
      unfold holds, less, minus. simpl. rewrite Z.
      assert (z + 1 <= 0)%Z as Y by lia. apply IZR_le in Y. rewrite plus_IZR in Y. lra.
    + apply (IH2 rho W K). intros l [<- | M]; [| exact (A l M)].
      unfold holds. simpl. rewrite Z, L. reflexivity.
    + apply (IH1 rho W K). intros l [<- | M]; [| exact (A l M)].
      unfold holds, less. simpl. rewrite Z.
      assert (0 + 1 <= z)%Z as Y by lia. apply IZR_le in Y. rewrite plus_IZR in Y. lra.
  - (* induction *)
    destruct (B rho W) as (n, N).
    assert (Main : forall m, (0 <= m)%Z -> forall rho', sorted rho' -> agree fixed rho rho' ->
      rho' v = IZR (n + m) -> (forall l, In l gs -> holds rho' l) -> holds rho' g).
    { intros m M. pattern m. apply Zlt_0_ind; [clear m M | exact M].
      intros m IHm M rho' W' Ag V A'.
      assert (N' : b rho' = IZR n) by (rewrite <- N; symmetry; apply Bf; exact Ag).
      assert (K' : forall h, In h H -> true_at fixed rho' h).
      { intros h Ih rho2 W2 Ag2. apply (K h Ih rho2 W2).
        intros u U. rewrite (Ag u U). exact (Ag2 u U). }
      destruct (Z.eq_dec m 0) as [-> | Mz].
      - assert (U : update rho' v (b rho') = rho').
        { rewrite N'. replace n with (n + 0)%Z by ring. rewrite <- V. apply update_same. }
        rewrite <- U. apply (IH1 rho' W' K'). apply (given_at rho' v b gs _ eq_refl).
        rewrite U. exact A'.
      - pose (rho2 := update rho' v (IZR (n + (m - 1)))).
        assert (W2 : sorted rho2) by (apply update_sorted; exact W').
        assert (Ag2 : agree fixed rho' rho2) by (apply update_agree; exact F).
        assert (V2 : rho2 v = IZR (n + (m - 1))) by apply update_value.
        assert (U : update rho2 v (rho2 v + 1) = rho').
        { unfold rho2 at 1. rewrite update_twice, V2, <- plus_IZR.
          replace (n + (m - 1) + 1)%Z with (n + m)%Z by ring. rewrite <- V. apply update_same. }
        rewrite <- U. apply (IH2 rho2 W2).
        + intros h [<- | Ih].
          * intros rho3 W3 Ag3 A3. simpl.
            pose proof (A3 _ (or_introl eq_refl)) as X. unfold holds in X. simpl in X.
            destruct (W3 t St) as (z, Z).
            rewrite <- (Ag3 v (or_intror eq_refl)), V2, Z in X.
            apply Rge_le in X. assert (z <= n + (m - 1))%Z by (apply le_IZR; lra).
            pose (rho4 := update rho3 v (rho3 t)).
            assert (A4 : forall l, In l gs -> holds rho4 l).
            { intros l L. apply (A3 (at_poly v (var t) l)). right. apply in_map. exact L. }
            assert (W4 : sorted rho4) by (unfold rho4; rewrite Z; apply update_sorted; exact W3).
            assert (Ag4 : agree fixed rho rho4).
            { intros u Fu. rewrite (Ag u Fu), (Ag2 u Fu), (Ag3 u (or_introl Fu)).
              exact (update_agree fixed rho3 v (rho3 t) F u Fu). }
            assert (V4 : rho4 v = IZR z) by (unfold rho4; rewrite update_value; exact Z).
            pose proof (A4 _ I) as Y. unfold holds in Y. simpl in Y.
            rewrite V4, <- (Bf _ _ Ag4), N in Y.
            apply Rge_le in Y. assert (n <= z)%Z by (apply le_IZR; lra).
            assert (V5 : rho4 v = IZR (n + (z - n))) by (rewrite V4; f_equal; lia).
            assert (Less : (0 <= z - n < m)%Z) by lia.
            exact (IHm (z - n)%Z Less rho4 W4 Ag4 V5 A4).
          * intros rho3 W3 Ag3. apply (K' h Ih rho3 W3).
            intros u Fu. rewrite (Ag2 u Fu). apply Ag3. left. exact Fu.
        + intros l [<- | L].
          * unfold holds. simpl. rewrite V2, <- (Bf rho' rho2 Ag2), N'.
            assert (n <= n + (m - 1))%Z as Y by lia. apply IZR_le in Y. lra.
          * revert l L. apply (given_at rho2 v _ gs _ eq_refl). rewrite U. exact A'. }
    pose proof (A _ I) as X. unfold holds in X. simpl in X.
    destruct (W v S) as (z, Z). rewrite Z, N in X.
    apply Rge_le in X. assert (n <= z)%Z by (apply le_IZR; lra).
    apply (Main (z - n)%Z); [lia | exact W | intros u _; reflexivity | | exact A].
    rewrite Z. f_equal. lia.
Qed.

(** What is derived from true lemmas is a true clause, and so may serve as a lemma itself. *)
Corollary derived_clauses_are_true lemmas gs g :
  (forall h rho, In h lemmas -> sorted rho -> true_at (fun _ => False) rho h) ->
  derives lemmas (fun _ => False) gs g ->
  forall rho, sorted rho -> true_at (fun _ => False) rho {| given := gs; goal := g |}.
Proof.
  intros L D rho _ rho' W' _ A. apply (sound _ _ _ _ D rho' W'); [| exact A].
  intros h I. apply L; assumption.
Qed.

End Kernel.

(** Definition: for every value of the other arguments, recursion on an integer from [n] on, with [depth] first values, defines
    a function. That [scale] is positive is known from [n] on only. *)
Theorem definition_exists (P : Type) (depth : nat) (base : P -> nat -> R) (step : P -> Z -> (Z -> R) -> R)
    (scale : P -> Z -> R) (n : Z) :
  (forall p z, (n <= z)%Z -> scale p z > 0) ->
  (forall p z f f', (forall j, (z <= j < z + Z.of_nat depth)%Z -> f j = f' j) -> step p z f = step p z f') ->
  exists f : P -> Z -> R,
    (forall p j, (j < depth)%nat -> f p (n + Z.of_nat j)%Z = base p j) /\
    (forall p z, (n <= z)%Z -> scale p z * f p (z + Z.of_nat depth)%Z = step p z (f p)).
Proof.
  intros Sc Ext.
  (* The values up to any height; each height keeps the values below it. *)
  pose (values := fun p => fix values (h : nat) : Z -> R :=
    match h with
    | O => fun z => base p (Z.to_nat (z - n))
    | S h => fun z => if Z.eq_dec z (n + Z.of_nat (depth + h))
                      then step p (n + Z.of_nat h)%Z (values h) / scale p (n + Z.of_nat h)%Z
                      else values h z
    end).
  assert (Keep : forall p h k z, (z < n + Z.of_nat (depth + h))%Z -> values p (h + k)%nat z = values p h z).
  { intros p h k z L. induction k as [| k IH]; [rewrite Nat.add_0_r; reflexivity |].
    rewrite Nat.add_succ_r. simpl. destruct (Z.eq_dec z (n + Z.of_nat (depth + (h + k)))); [lia | exact IH]. }
  exists (fun p z => values p (Z.to_nat (z - n + 1)) z). split.
  - intros p j J.
    pose proof (Keep p 0%nat (Z.to_nat (n + Z.of_nat j - n + 1)) (n + Z.of_nat j)%Z) as E.
    rewrite Nat.add_0_l in E. rewrite E by lia. simpl.
    replace (Z.to_nat (n + Z.of_nat j - n)) with j by lia. reflexivity.
  - intros p z L. cbv beta. pose (h := Z.to_nat (z - n)).
    assert (Hz : z = (n + Z.of_nat h)%Z) by (unfold h; lia).
    pose proof (Keep p (S h) depth (z + Z.of_nat depth)%Z) as E.
    replace (Z.to_nat (z + Z.of_nat depth - n + 1)) with (S h + depth)%nat by lia.
    rewrite E by lia. cbn [values].
    destruct (Z.eq_dec (z + Z.of_nat depth) (n + Z.of_nat (depth + h))) as [_ | Ne]; [| lia].
    rewrite <- Hz. pose proof (Sc p z L) as Q. field_simplify; [| lra].
    apply Ext. intros j J.
    destruct (Nat.le_gt_cases h (Z.to_nat (j - n + 1))) as [Le | Gt].
    + pose proof (Keep p h (Z.to_nat (j - n + 1) - h)%nat j) as K.
      replace (h + (Z.to_nat (j - n + 1) - h))%nat with (Z.to_nat (j - n + 1)) in K by lia.
      symmetry. apply K. lia.
    + lia.
Qed.
