package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.workshop.prove.portals.DoorwayRooms.Doors;
import nephele.workshop.prove.portals.DoorwayWalk.Manner;
import nephele.workshop.prove.portals.FrameSteps.Step;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Walks with the same input through 0 to 3 portals and through as many open doorways of the same shape, in first
 * person, with the camera boom and with a cube in hand. It compares each frame with the frame before it, which detects
 * pops, and each frame with its twin.
 */
public final class DoorwayWalkProof implements Proof {
    private static final int MOST_DOORS = 3;
    private static final int FRAMES_PER_SECOND = 60;
    private static final double METRES_PER_SECOND = 4;
    /**
     * The relative excess that the mean step between two frames may have over the twin's: edges beyond a portal fall on
     * neighbouring pixels.
     */
    private static final double STEP_FRACTION = 0.01;

    /** The excess, in codes, that the step at the 99.9th percentile of channels may have over the twin's. */
    private static final int STEP_MOST = 2;

    /**
     * The mean difference between a frame and its twin, in codes, caused by edges that fall on neighbouring pixels. At
     * 160 by 90 pixels they come to 1.0; one row of 90 that is wrong by half the range adds 1.4.
     */
    private static final double TWIN_CODES = 2;
    /** Tolerance in metres; sums of a few hundred steps round to 10⁻¹³ m. */
    private static final double APART_METRES = 1e-9;

    private final int width;
    private final int height;

    public DoorwayWalkProof(int width, int height) {
        this.width = width;
        this.height = height;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "doorway-walk",
                "Walking through portals looks as walking through doorways does, frame by frame: with the eye, on the"
                    + " boom, with a cube in hand, through none to three of them. The greatest step between two frames"
                    + " is at most 1 % (on average) and 2 codes (of 999 in 1000 channels) greater, no pixel away from"
                    + " edges differs from the doorway's by more than 2 codes, a frame by 2 codes on average, and the"
                    + " player by 1e-9 m.",
                "walks",
                (long) Manner.values().length * (MOST_DOORS + 1),
                MOST_DOORS + 1);
    }

    /** Runs units; unit n goes through n modulo 4 doors. */
    @Override
    public ProofResult run(long from, long count, Progress progress) {
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, width, height)) {
            return ProofResult.ofUnits(from, count, progress, unit -> {
                Manner manner = Manner.values()[(int) (unit / (MOST_DOORS + 1)) % Manner.values().length];
                return walk(gl, picture, (int) (unit % (MOST_DOORS + 1)), manner);
            });
        }
    }

    private ProofResult walk(GlContext gl, RenderTarget picture, int doors, Manner manner) {
        try (var open = new DoorwayWalk(gl, picture, Doors.OPEN, doors, manner);
                var through = new DoorwayWalk(gl, picture, Doors.PORTALS, doors, manner)) {
            double twin = 0;
            long strange = 0;
            long count = 30 + Math.round(doors * DoorwayRooms.PITCH_METRES / METRES_PER_SECOND * FRAMES_PER_SECOND);
            for (long frame = 0; frame < count; frame++) {
                long nanos = 1_000_000_000L / FRAMES_PER_SECOND;
                byte[] a = open.frame(nanos);
                byte[] b = through.frame(nanos);
                twin = Math.max(twin, FrameSteps.between(a, b).mean());
                strange += FrameSteps.strangers(a, b, width);
            }
            Step doorway = open.greatestStep();
            Step portal = through.greatestStep();
            double apart = apart(open, through, doors);
            List<String> failures = new ArrayList<>();
            if (portal.mean() > doorway.mean() * (1 + STEP_FRACTION)
                    || portal.most() > doorway.most() + STEP_MOST
                    || strange > 0
                    || !(twin <= TWIN_CODES && apart <= APART_METRES)) {
                failures.add(String.format(
                        Locale.ROOT,
                        "%s through %d: steps %.3f and %d codes, doorways %.3f and %d; %d strange pixels; twin %.3f"
                                + " codes and %.3g m apart",
                        manner,
                        doors,
                        portal.mean(),
                        portal.most(),
                        doorway.mean(),
                        doorway.most(),
                        strange,
                        twin,
                        apart));
            }
            return ProofResult.of(
                    1,
                    failures,
                    Figure.sum("frames", count, ""),
                    Figure.greatest("mean difference of a frame from its twin", twin, "codes"),
                    Figure.sum("pixels away from edges that differ from the twin's", strange, ""),
                    Figure.greatest(
                            "step between frames beyond the doorways'",
                            100 * (portal.mean() / doorway.mean() - 1),
                            "%"),
                    Figure.greatest("player from its twin", apart, "m"));
        }
    }

    /** Returns the distance in metres between both players, in the room's own space in which it is least. */
    private static double apart(DoorwayWalk open, DoorwayWalk through, int doors) {
        double least = Double.POSITIVE_INFINITY;
        Vec3 there = through.walk().state().player().feet();
        for (int room = 0; room <= doors; room++) {
            Vec3 twin = DoorwayRooms.twin(open.walk().state().player().feet(), room);
            least = Math.min(least, twin.toVector().distance(there.toVector()));
        }
        return least;
    }
}
