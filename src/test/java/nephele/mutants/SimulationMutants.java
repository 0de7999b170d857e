package nephele.mutants;

import static nephele.mutants.Mutant.Area.SIMULATION;
import static nephele.mutants.Mutants.ENGINE;

import java.util.List;

/** Faults in the player's motion, the hands and the handling of time. */
final class SimulationMutants {
    static final List<Mutant> ALL = List.of(
            new Mutant(
                    SIMULATION,
                    "who stands in a portal that moves is put out of it without the skin",
                    ENGINE + "sim/carry/PortalOccupants.java",
                    "behind + Sweep.SKIN_METRES - portal",
                    "behind - portal",
                    "PortalOccupantsPushTest"),
            new Mutant(
                    SIMULATION,
                    "noise reaches 1 at the end of a cell",
                    ENGINE + "math/SeededNoise.java",
                    "Math.min(coordinate - Math.floor(coordinate), Math.nextDown(1.0))",
                    "coordinate - Math.floor(coordinate)",
                    "SeededNoiseTest"),
            new Mutant(
                    SIMULATION,
                    "the rest of a tick is lost after each frame",
                    ENGINE + "sim/FixedStep.java",
                    "rest %= NANOS_PER_SECOND;",
                    "rest = 0;",
                    "FixedStepTest"),
            new Mutant(
                    SIMULATION,
                    "slopes are walked as fast as their projections",
                    ENGINE + "sim/player/GroundWalk.java",
                    "Math.sqrt(square / (square + rise * rise))",
                    "1",
                    "PlayerMotionTest"),
            new Mutant(
                    SIMULATION,
                    "a view turns upright by the longer way",
                    ENGINE + "sim/state/Tilt.java",
                    "Math.abs(w)",
                    "w",
                    "TiltTest"),
            new Mutant(
                    SIMULATION,
                    "what is out of sight is held a tick longer",
                    ENGINE + "sim/carry/CarryRules.java",
                    "held.ticksUnseen() < graceTicks",
                    "held.ticksUnseen() <= graceTicks",
                    "CarryRulesTest"),
            new Mutant(
                    SIMULATION,
                    "two bodies met at one place are pushed twice",
                    ENGINE + "sim/player/BodyPushes.java",
                    "Math.max(0, Math.min(rest, legs) + push.dot(n))",
                    "Math.min(rest, legs)",
                    "BodyPushesTest"));

    private SimulationMutants() {}
}
