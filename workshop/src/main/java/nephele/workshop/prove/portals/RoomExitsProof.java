package nephele.workshop.prove.portals;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Sends players with the game's assists through random portals, lets them come to rest without a key, and then has them
 * walk in eight directions: one of these has to lead away. Players that still fall from portal to portal are in no corner,
 * and those flung into a hole of the room, as behind its ramp, did not find it at the exit; both are counted apart.
 */
public final class RoomExitsProof implements Proof {
    private static final long EXITS_PER_ROOM = 100;
    private static final int[] RATES = {30, 60, 120, 120, 120, 240};
    private static final double REST_SECONDS = 4;
    private static final double WALK_SECONDS = 1;

    /** Distance from its resting place at which a walking player counts as out of the corner. */
    private static final double AWAY_METRES = 0.5;

    /** Distance from the exit portal beyond which an end is counted apart: {@code exit-room} does not act there. */
    private static final double EXIT_METRES = 1;

    private static final double AT_REST_METRES_PER_SECOND = 1e-3;
    private static final int DIRECTIONS = 8;
    private static final String WITHOUT = "units without a crossing";
    private static final String MOVING = "still falling from portal to portal";
    private static final String HOLES = "flung more than 1 m away, into a hole of the room";
    private static final String NONE = "";

    @Override
    public Claim claim() {
        return new Claim(
                "room-exits",
                "A player that comes out of a portal ends in no solid and in no corner that walking does not leave.",
                "exits",
                100_000,
                5_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        CrossingPlayers players = null;
        long number = -1;
        for (long unit = from; unit < from + count; unit++) {
            if (number != unit / EXITS_PER_ROOM) {
                number = unit / EXITS_PER_ROOM;
                PortalRoom room = PortalRoom.of(new SplittableRandom(number));
                int rate = RATES[(int) (number % RATES.length)];
                players = new CrossingPlayers(room, new SimSettings(rate, Assist.USUAL));
            }
            result = result.and(exit(players, RATES[(int) (number % RATES.length)], unit));
            progress.unitsDone(unit + 1 - from);
        }
        return result;
    }

    private static ProofResult exit(CrossingPlayers players, int rate, long unit) {
        SimState out = players.crossed(new SplittableRandom(unit ^ 0x5DEECE66DL));
        if (out == null) {
            return ended(WITHOUT);
        }
        SimState rest = out;
        Vec3 exit = out.player().feet();
        for (int tick = 0; tick < REST_SECONDS * rate && !isAtRest(rest); tick++) {
            rest = players.step(rest, PlayerInput.NONE);
            exit = rest.world().trace().playerCrossed().length() > 0
                    ? rest.player().feet()
                    : exit;
        }
        double depth = players.depth(rest.player());
        if (depth > 0) {
            return failed("exit " + unit + ": " + depth + " m in a solid: " + rest.player());
        } else if (!isAtRest(rest)) {
            return ended(MOVING);
        } else if (leaves(players, rate, rest)) {
            return ended(NONE);
        }
        double metres = Math.hypot(
                rest.player().feet().x() - exit.x(), rest.player().feet().z() - exit.z());
        return metres > EXIT_METRES ? ended(HOLES) : failed("exit " + unit + " ends in a corner: " + rest.player());
    }

    private static ProofResult failed(String example) {
        return ended(NONE).and(ProofResult.of(0, List.of(example)));
    }

    /** Returns the result of an exit that one of the figures counts, or none. */
    private static ProofResult ended(String figure) {
        return ProofResult.of(
                1,
                List.of(),
                Figure.sum(WITHOUT, figure.equals(WITHOUT) ? 1 : 0, ""),
                Figure.sum(MOVING, figure.equals(MOVING) ? 1 : 0, ""),
                Figure.sum(HOLES, figure.equals(HOLES) ? 1 : 0, ""));
    }

    private static boolean isAtRest(SimState state) {
        return state.player().isGrounded()
                && state.player().velocity().length() < AT_REST_METRES_PER_SECOND
                && !state.world().arrival().isRecent();
    }

    private static boolean leaves(CrossingPlayers players, int rate, SimState rest) {
        for (int i = 0; i < DIRECTIONS; i++) {
            SimState state = players.step(rest, PlayerInput.NONE.turning(i * 360_000 / DIRECTIONS, 0));
            for (int tick = 0; tick < WALK_SECONDS * rate; tick++) {
                state = players.step(state, PlayerInput.FORWARD);
                Vec3 walked = state.player().feet().minus(rest.player().feet());
                if (state.world().trace().playerCrossed().length() > 0
                        || walked.x() * walked.x() + walked.z() * walked.z() > AWAY_METRES * AWAY_METRES) {
                    return true;
                }
            }
        }
        return false;
    }
}
