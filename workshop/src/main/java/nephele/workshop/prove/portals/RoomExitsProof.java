package nephele.workshop.prove.portals;

import java.util.ArrayList;
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
    private static final int MOST_EXAMPLES = 10;

    /** The results of a range of exits. */
    private static final class Tally {
        long without;
        long moving;
        long holes;
        final List<String> failures = new ArrayList<>();
    }

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
        Tally tally = new Tally();
        CrossingPlayers players = null;
        long number = -1;
        for (long unit = from; unit < from + count; unit++) {
            if (number != unit / EXITS_PER_ROOM) {
                number = unit / EXITS_PER_ROOM;
                PortalRoom room = PortalRoom.of(new SplittableRandom(number));
                int rate = RATES[(int) (number % RATES.length)];
                players = new CrossingPlayers(room, new SimSettings(rate, Assist.USUAL));
            }
            exit(players, RATES[(int) (number % RATES.length)], unit, tally);
            progress.unitsDone(unit + 1 - from);
        }
        return new ProofResult(
                count,
                tally.failures.size(),
                List.of(
                        Figure.sum("units without a crossing", tally.without, ""),
                        Figure.sum("still falling from portal to portal", tally.moving, ""),
                        Figure.sum("flung more than 1 m away, into a hole of the room", tally.holes, "")),
                tally.failures.subList(0, Math.min(tally.failures.size(), MOST_EXAMPLES)));
    }

    private static void exit(CrossingPlayers players, int rate, long unit, Tally tally) {
        SimState out = players.crossed(new SplittableRandom(unit ^ 0x5DEECE66DL));
        if (out == null) {
            tally.without++;
            return;
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
            tally.failures.add("exit " + unit + ": " + depth + " m in a solid: " + rest.player());
        } else if (!isAtRest(rest)) {
            tally.moving++;
        } else if (leaves(players, rate, rest)) {
            return;
        } else if (Math.hypot(
                        rest.player().feet().x() - exit.x(),
                        rest.player().feet().z() - exit.z())
                > EXIT_METRES) {
            tally.holes++;
        } else {
            tally.failures.add("exit " + unit + " ends in a corner: " + rest.player());
        }
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
