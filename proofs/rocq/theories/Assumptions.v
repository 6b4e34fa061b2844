(* The assumptions of every theorem of theorems.tsv, in its order; check.sh compares
   them with allowed-assumptions.txt. *)
From Cordon Require Proofs.Ordering.
From Cordon Require Proofs.UpperBound.
From Cordon Require Proofs.Sum.
From Cordon Require Proofs.NonDecreasing.
From Cordon Require Proofs.FixedPoint.
From Cordon Require Proofs.Increasing.
From Cordon Require Proofs.Limit.
From Cordon Require Proofs.ExactLimit.
From Cordon Require Proofs.Critical.
From Cordon Require Proofs.Certificate.
From Cordon Require Proofs.Dynamics.
From Cordon Require Proofs.Projection.
From Cordon Require Proofs.Activation.
From Cordon Require Proofs.Delay.
From Cordon Require Proofs.Consensus.
From Cordon Require Proofs.ConsensusPath.
From Cordon Require Proofs.Rational.

Print Assumptions Proofs.Ordering.ordering_sharp.
Print Assumptions Proofs.Ordering.ordering_three.
Print Assumptions Proofs.Ordering.ordering_ticks.
Print Assumptions Proofs.Ordering.ordering_paper.
Print Assumptions Proofs.Ordering.ordering_exact.
Print Assumptions Proofs.Ordering.ordering_three_exact.
Print Assumptions Proofs.UpperBound.upper_bound_sharp.
Print Assumptions Proofs.UpperBound.lower_bound_sharp.
Print Assumptions Proofs.UpperBound.box_sharp.
Print Assumptions Proofs.UpperBound.upper_bound_ticks.
Print Assumptions Proofs.UpperBound.lower_bound_ticks.
Print Assumptions Proofs.UpperBound.box_ticks.
Print Assumptions Proofs.UpperBound.first_subsegment_upper_bounded.
Print Assumptions Proofs.UpperBound.upper_bound_paper.
Print Assumptions Proofs.UpperBound.upper_bound_exact.
Print Assumptions Proofs.Sum.sum_bounded_sharp.
Print Assumptions Proofs.Sum.sum_maximal_sharp.
Print Assumptions Proofs.Sum.sum_paper.
Print Assumptions Proofs.NonDecreasing.sum_identity.
Print Assumptions Proofs.NonDecreasing.telescoping_residual_zero.
Print Assumptions Proofs.NonDecreasing.sum_non_decreasing_sharp.
Print Assumptions Proofs.NonDecreasing.sum_monotone.
Print Assumptions Proofs.NonDecreasing.sum_non_decreasing_paper.
Print Assumptions Proofs.FixedPoint.sum_stationary_sharp.
Print Assumptions Proofs.FixedPoint.targets_fixed_sharp.
Print Assumptions Proofs.FixedPoint.targets_fixed_sum.
Print Assumptions Proofs.FixedPoint.constant_sum_bounded.
Print Assumptions Proofs.FixedPoint.constant_sum_sharp.
Print Assumptions Proofs.FixedPoint.constant_sum_paper.
Print Assumptions Proofs.FixedPoint.constant_sum_zero_weight.
Print Assumptions Proofs.Increasing.increasing_sharp.
Print Assumptions Proofs.Increasing.increasing_within.
Print Assumptions Proofs.Increasing.increasing_paper.
Print Assumptions Proofs.Limit.limit_rate.
Print Assumptions Proofs.Limit.limit_half.
Print Assumptions Proofs.Limit.limit_ticks.
Print Assumptions Proofs.Limit.limit_both_phases.
Print Assumptions Proofs.ExactLimit.limit_exact_rate.
Print Assumptions Proofs.ExactLimit.limit_exact_rate_attained.
Print Assumptions Proofs.ExactLimit.limit_sharp.
Print Assumptions Proofs.ExactLimit.limit_sharp_ticks.
Print Assumptions Proofs.ExactLimit.limit_iff.
Print Assumptions Proofs.ExactLimit.critical_weight_3.
Print Assumptions Proofs.ExactLimit.critical_weight_4.
Print Assumptions Proofs.ExactLimit.critical_weight_5.
Print Assumptions Proofs.ExactLimit.half_is_below_critical.
Print Assumptions Proofs.ExactLimit.half_is_fastest.
Print Assumptions Proofs.Critical.below_critical_correct.
Print Assumptions Proofs.Certificate.certificate_rate.
Print Assumptions Proofs.Certificate.certificate_converges.
Print Assumptions Proofs.Certificate.certificate_diverges.
Print Assumptions Proofs.Dynamics.ticks_iterate.
Print Assumptions Proofs.Dynamics.kth_step_protocol_step.
Print Assumptions Proofs.Dynamics.kth_step_reaches.
Print Assumptions Proofs.Dynamics.kth_step_every_tick.
Print Assumptions Proofs.Projection.projection.
Print Assumptions Proofs.Projection.projection_positions.
Print Assumptions Proofs.Activation.ordering_active.
Print Assumptions Proofs.Activation.upper_bound_active.
Print Assumptions Proofs.Activation.lower_bound_active.
Print Assumptions Proofs.Activation.box_active.
Print Assumptions Proofs.Delay.delayed_step_run.
Print Assumptions Proofs.Delay.upper_bound_delayed.
Print Assumptions Proofs.Delay.lower_bound_delayed.
Print Assumptions Proofs.Delay.box_delayed.
Print Assumptions Proofs.Delay.limit_rate_delayed.
Print Assumptions Proofs.Delay.limit_delayed.
Print Assumptions Proofs.Delay.ordering_delayed_fails.
Print Assumptions Proofs.Consensus.consensus_sum.
Print Assumptions Proofs.Consensus.consensus_average.
Print Assumptions Proofs.Consensus.consensus_fixed.
Print Assumptions Proofs.ConsensusPath.consensus_path_rate.
Print Assumptions Proofs.ConsensusPath.consensus_path_limit.
Print Assumptions Proofs.ConsensusPath.consensus_path_iff.
Print Assumptions Proofs.Consensus.formation_sum.
Print Assumptions Proofs.Consensus.formation_without_input.
Print Assumptions Proofs.Rational.execution_is_proved.
Print Assumptions Proofs.Rational.consensus_execution_is_proved.
