package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Sends one body through random pairs and back through the same, without a restart, and checks that it returns to its
 * place: once as a point, directions and an orientation through the bare portal transforms, and as often again as
 * thrown bodies of the solver ({@link FlownTraversals}). The three axes are transformed as directions, which are never
 * normalised or made perpendicular again. The rounding of a passage and its return is the same each time, so that it
 * adds up; random paths would average it.
 */
public final class TraversalsProof implements Proof {
    private static final int PAIRS = 40;
    private static final double SPREAD_METRES = 100;
    static final double PLACE_BAR_METRES = 1e-6;
    static final double SPEED_BAR = 1e-8;
    static final double BASIS_BAR = 1e-9;
    /**
     * The largest dot product of normal and up; an up nearer than 0.8° to the normal does not define an orientation.
     */
    private static final double MOST_ALONG = 0.9999;
    /** The length of a chain of traversals; a proof over a million is one chain. */
    private static final long CHAIN = 1_000_000;

    @Override
    public Claim claim() {
        return new Claim(
                "traversals",
                "A million traversals of random portal pairs change neither position, speed nor orthonormal"
                        + " axes by more than rounding.",
                "traversals",
                CHAIN,
                CHAIN);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var random = new SplittableRandom(from);
        Traveller traveller = new Traveller(random);
        PortalTransform[][] transforms = transforms(random);
        for (long i = 0; i < count; i += 2) {
            PortalTransform[] pair = transforms[random.nextInt(PAIRS)];
            traveller.thereAndBack(pair[0], pair[1]);
            progress.unitsDone(i);
        }
        return traveller.result(count).and(new FlownTraversals(random).run(count));
    }

    /**
     * Returns the angle between two orientations in radians, for small angles: twice the length of the vector part of
     * q1* q2.
     */
    static double turned(Quaterniond from, Quaterniond to) {
        Quaterniond between = from.conjugate(new Quaterniond()).mul(to);
        return 2 * Math.sqrt(between.x * between.x + between.y * between.y + between.z * between.z);
    }

    private static PortalTransform[][] transforms(SplittableRandom random) {
        PortalTransform[][] transforms = new PortalTransform[PAIRS][];
        for (int i = 0; i < PAIRS; i++) {
            Portal a = anywhere(random);
            Portal b = anywhere(random);
            transforms[i] = new PortalTransform[] {PortalTransform.between(a, b), PortalTransform.between(b, a)};
        }
        return transforms;
    }

    /** Returns a portal with normal and up uniform over the sphere. */
    static Portal anywhere(SplittableRandom random) {
        Vec3 centre = new Vec3(
                random.nextDouble(-SPREAD_METRES, SPREAD_METRES),
                random.nextDouble(-SPREAD_METRES, SPREAD_METRES),
                random.nextDouble(-SPREAD_METRES, SPREAD_METRES));
        Vec3 normal = direction(random);
        Vec3 up = direction(random);
        while (Math.abs(normal.dot(up)) > MOST_ALONG) {
            up = direction(random);
        }
        return new Portal("end", centre, Portal.facing(normal, up), Aperture.of(PortalShape.ARCH, 1.2, 2.1));
    }

    /** Returns a direction, uniform over the sphere: z and the longitude are uniform (Archimedes). */
    private static Vec3 direction(SplittableRandom random) {
        double z = random.nextDouble(-1, 1);
        double longitude = random.nextDouble(2 * Math.PI);
        double around = Math.sqrt(1 - z * z);
        return Directions.unit(around * Math.cos(longitude), around * Math.sin(longitude), z);
    }

    /** A body that goes through a pair and returns through it, so that it should be at its initial place. */
    private static final class Traveller {
        private final Vector3d place;
        private final Vector3d velocity;
        private final Quaterniond orientation = new Quaterniond();
        private final Vector3d x = new Vector3d(1, 0, 0);
        private final Vector3d y = new Vector3d(0, 1, 0);
        private final Vector3d z = new Vector3d(0, 0, 1);
        private final Vector3d firstPlace;
        private final double firstSpeed;
        private final Quaterniond firstOrientation = new Quaterniond();
        private double worstSpeed;
        private double worstBasis;

        Traveller(SplittableRandom random) {
            place = new Vector3d(random.nextDouble(-50, 50), random.nextDouble(-50, 50), random.nextDouble(-50, 50));
            velocity = new Vector3d(random.nextDouble(1, 9), random.nextDouble(-9, 9), random.nextDouble(-9, 9));
            firstPlace = new Vector3d(place);
            firstSpeed = velocity.length();
        }

        void thereAndBack(PortalTransform there, PortalTransform back) {
            go(there);
            go(back);
        }

        private void go(PortalTransform transform) {
            transform.point(place);
            transform.direction(velocity);
            transform.orientation(orientation);
            transform.direction(x);
            transform.direction(y);
            transform.direction(z);
            worstSpeed = Math.max(worstSpeed, Math.abs(velocity.length() / firstSpeed - 1));
            double skew = Math.max(Math.abs(x.dot(y)), Math.max(Math.abs(y.dot(z)), Math.abs(z.dot(x))));
            double stretch = Math.max(stretch(x), Math.max(stretch(y), stretch(z)));
            worstBasis = Math.max(worstBasis, Math.max(skew, stretch));
        }

        private static double stretch(Vector3d axis) {
            return Math.abs(axis.lengthSquared() - 1);
        }

        ProofResult result(long count) {
            double off = place.distance(firstPlace);
            double turned = turned(orientation, firstOrientation);
            List<String> failures = new ArrayList<>();
            if (!(off <= PLACE_BAR_METRES)) {
                failures.add("the body is " + off + " m from its place");
            }
            if (!(worstSpeed <= SPEED_BAR)) {
                failures.add("its speed is off by " + worstSpeed);
            }
            if (!(worstBasis <= BASIS_BAR)) {
                failures.add("its axes are off orthonormal by " + worstBasis);
            }
            if (!(turned <= BASIS_BAR)) {
                failures.add("it is turned by " + turned);
            }
            return ProofResult.of(
                    count,
                    failures,
                    Figure.greatest("distance from its place", off, "m"),
                    Figure.greatest("speed off, of itself", worstSpeed, ""),
                    Figure.greatest("axes off orthonormal, never made unit again", worstBasis, ""),
                    Figure.greatest("orientation off", turned, "rad"));
        }
    }
}
