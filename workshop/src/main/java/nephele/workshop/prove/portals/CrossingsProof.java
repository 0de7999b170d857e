package nephele.workshop.prove.portals;

import java.util.SplittableRandom;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Sends players (even units) and thrown boxes, balls and capsules (odd units) through random portals, and checks their
 * place a quarter of a second later. A unit is a crossing: its start is drawn again until it goes through.
 */
public final class CrossingsProof implements Proof {
    /** After so many tries a unit has no crossing; it is counted separately. */
    static final int MOST_TRIES = 200;

    private static final long CROSSINGS_PER_ROOM = 500;
    private static final int[] RATES = {30, 60, 120, 120, 120, 240};

    @Override
    public Claim claim() {
        return new Claim(
                "crossings",
                "A player or body that goes through a portal falls through no floor and ends in no solid.",
                "crossings",
                1_000_000,
                50_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        CrossingTally tally = new CrossingTally();
        long number = -1;
        CrossingPlayers players = null;
        CrossingBodies bodies = null;
        for (long unit = from; unit < from + count; unit++) {
            if (number != unit / CROSSINGS_PER_ROOM) {
                number = unit / CROSSINGS_PER_ROOM;
                PortalRoom room = PortalRoom.of(new SplittableRandom(number));
                int rate = RATES[(int) (number % RATES.length)];
                players = new CrossingPlayers(room, rate);
                bodies = new CrossingBodies(room, rate, number);
            }
            var random = new SplittableRandom(unit ^ 0x5DEECE66DL);
            String where = "crossing " + unit + " in room " + number;
            boolean crossed = unit % 2 == 0 ? players.cross(random, where, tally) : bodies.cross(random, where, tally);
            if (crossed) {
                tally.through();
            } else {
                tally.without();
            }
            progress.unitsDone(unit + 1 - from);
        }
        return tally.result(count);
    }
}
