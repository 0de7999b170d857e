package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/** Loads light cubes with heavy ones. A unit is one of three stacks at one of three tick rates. */
public final class MassRatiosProof implements Proof {
    private static final double SUNK_METRES = .001;
    private static final double FAST_METRES_PER_SECOND = 5;
    private static final double UNLOADED_SECONDS = 1;
    private static final double GAP_METRES = .002;
    private static final double FRICTION = .6;
    private static final Vec3 GRAVITY = new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0);
    private static final int[] RATES = {30, 60, 1000};
    private static final int STACKS = 3;

    private final double seconds;

    /** @param seconds for which each stack carries its load */
    public MassRatiosProof(double seconds) {
        this.seconds = seconds;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "mass-ratios",
                "A tonne on a gram, and towers of twelve cubes each 2 or 3.16 times as heavy as the one below, at 30,"
                        + " 60 and 1000 ticks a second: none sleeps more than 1 mm in the floor or in another, none is"
                        + " faster than 5 m/s, and the lowest is out of the floor within 1 s after the others are taken"
                        + " away.",
                "stacks",
                (long) RATES.length * STACKS,
                (long) RATES.length * STACKS);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        return ProofResult.ofUnits(from, count, progress, unit -> {
            int rate = RATES[(int) (unit % RATES.length)];
            return stack((int) (unit / RATES.length)).run(rate, seconds);
        });
    }

    private static Stack stack(int number) {
        return switch (number) {
            case 0 -> new Stack("1 t on 1 g", tonneOnGram());
            case 1 -> new Stack("tower of ratio 2", tower(2));
            default -> new Stack("tower of ratio 3.16", tower(3.16));
        };
    }

    /** Returns a cube of 1 t and 1 m on a cube of 1 g and 5 cm. */
    private static List<Body> tonneOnGram() {
        return List.of(cube(0, .025, .05, .001), cube(1, .05 + GAP_METRES + .5, 1, 1000));
    }

    /**
     * Returns twelve cubes of 40 cm, each {@code ratio} times as heavy as the one below; their geometric mean is 10 kg.
     */
    private static List<Body> tower(double ratio) {
        List<Body> bodies = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            bodies.add(cube(i, .2 + i * (.4 + GAP_METRES), .4, 10 * StrictMath.pow(ratio, i - 5.5)));
        }
        return bodies;
    }

    private static Body cube(int number, double height, double edge, double kilograms) {
        return new Body.Box(
                "b" + number, new Vec3(0, height, 0), new Vec3(edge, edge, edge), kilograms, null, FRICTION, 0);
    }

    /** A light cube under a heavy load that is then removed. */
    private static final class Stack {
        private final PortalWorld world = PortalWorld.of(BoxPile.closedRoom(6, 8, 1), Portals.NONE);
        private final Vector3d velocity = new Vector3d();
        private final String name;
        private final List<Body> bodies;
        /** The greatest depth in the floor or in another body at which a body slept, in metres. */
        private double sleepsDeep;
        /** The greatest speed of any body at any tick, with the load and without, in m/s. */
        private double fastest;

        Stack(String name, List<Body> bodies) {
            this.name = name;
            this.bodies = bodies;
        }

        ProofResult run(int rate, double seconds) {
            BodyTable loaded = new BodyTable(bodies);
            Bodies end = move(loaded, loaded.start(), rate, seconds);
            BodyTable lowest = new BodyTable(bodies.subList(0, 1));
            Bodies unloaded = move(lowest, Bodies.of(List.of(end.state(0))), rate, UNLOADED_SECONDS);
            double sunk = new BodyDepth(lowest, world).inSolids(unloaded, 0);
            List<String> failures = new ArrayList<>();
            if (!(sleepsDeep <= SUNK_METRES && fastest <= FAST_METRES_PER_SECOND && sunk <= SUNK_METRES)) {
                failures.add(String.format(
                        Locale.ROOT,
                        "%s at %d ticks/s: sleeps %.3f mm deep, moves at %.3f m/s, is %.3f mm in the floor unloaded",
                        name,
                        rate,
                        sleepsDeep * 1000,
                        fastest,
                        sunk * 1000));
            }
            return ProofResult.of(
                    1,
                    failures,
                    Figure.greatest(name + ", sleeps deep", sleepsDeep * 1000, "mm"),
                    Figure.greatest(name + ", fastest", fastest, "m/s"),
                    Figure.greatest(name + ", unloaded, in the floor", sunk * 1000, "mm"));
        }

        private Bodies move(BodyTable table, Bodies start, int rate, double seconds) {
            RigidStep step = new RigidStep(table, GRAVITY);
            BodyDepth depth = new BodyDepth(table, world);
            BodyInfluences nobody = BodyInfluences.none();
            Bodies bodies = start;
            for (int tick = 0; tick < seconds * rate; tick++) {
                Bodies next = step.step(bodies, world, nobody, 1.0 / rate);
                look(bodies, next, depth);
                bodies = next;
            }
            return bodies;
        }

        private void look(Bodies before, Bodies now, BodyDepth depth) {
            for (int i = 0; i < now.size(); i++) {
                double speed = now.velocity(i, velocity).length();
                fastest = speed <= fastest ? fastest : speed;
                if (now.isAsleep(i) && !before.isAsleep(i)) {
                    sleepsDeep = Math.max(sleepsDeep, Math.max(depth.inSolids(now, i), depth.inBodies(now, i)));
                }
            }
        }
    }
}
