package nephele.app.prove;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Passage;
import nephele.engine.portal.Portal;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Sends one body through random pairs and back by the same, without ever starting anew: it ought to be where it was.
 * What rounding leaves of there and back is the same each time, so that it adds up; random ways would average it.
 */
public final class TraversalsProof implements Proof {
    private static final int PAIRS = 40;
    private static final double SPREAD_METRES = 100;
    private static final double PLACE_BAR_METRES = 1e-6;
    private static final double SPEED_BAR = 1e-8;
    private static final double BASIS_BAR = 1e-9;
    /** One chain of traversals; a proof over a million is one chain. */
    private static final long CHAIN = 1_000_000;

    @Override
    public String name() {
        return "traversals";
    }

    @Override
    public String claim() {
        return "A million passages through random pairs move, speed up and bend nothing.";
    }

    @Override
    public String unit() {
        return "traversals";
    }

    @Override
    public long fullCount() {
        return CHAIN;
    }

    @Override
    public long batch() {
        return CHAIN;
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var random = new SplittableRandom(from);
        Traveller traveller = new Traveller(random);
        Passage[][] passages = passages(random);
        for (long i = 0; i < count; i += 2) {
            Passage[] pair = passages[random.nextInt(PAIRS)];
            traveller.thereAndBack(pair[0], pair[1]);
            if (i % 10_000 == 0) {
                progress.unitsDone(i);
            }
        }
        return traveller.result(count);
    }

    private static Passage[][] passages(SplittableRandom random) {
        Passage[][] passages = new Passage[PAIRS][];
        for (int i = 0; i < PAIRS; i++) {
            Portal a = anywhere(random);
            Portal b = anywhere(random);
            passages[i] = new Passage[] {Passage.between(a, b), Passage.between(b, a)};
        }
        return passages;
    }

    private static Portal anywhere(SplittableRandom random) {
        Vec3 centre = new Vec3(
                random.nextDouble(-SPREAD_METRES, SPREAD_METRES),
                random.nextDouble(-SPREAD_METRES, SPREAD_METRES),
                random.nextDouble(-SPREAD_METRES, SPREAD_METRES));
        Vec3 normal = new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(0.1, 1));
        Vec3 up = new Vec3(random.nextDouble(-1, 1), random.nextDouble(0.1, 1), random.nextDouble(-1, 1));
        return new Portal("end", centre, Portal.facing(normal, up), Aperture.of(PortalShape.ARCH, 1.2, 2.1));
    }

    /** A body that goes through a pair and comes back by it: it is where it was. */
    private static final class Traveller {
        private final Vector3d place;
        private final Vector3d velocity;
        private final Quaterniond orientation = new Quaterniond();
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

        void thereAndBack(Passage there, Passage back) {
            there.point(place);
            there.direction(velocity);
            there.orientation(orientation);
            look();
            back.point(place);
            back.direction(velocity);
            back.orientation(orientation);
            look();
        }

        private void look() {
            worstSpeed = Math.max(worstSpeed, Math.abs(velocity.length() / firstSpeed - 1));
            Vector3d x = orientation.transform(new Vector3d(1, 0, 0));
            Vector3d y = orientation.transform(new Vector3d(0, 1, 0));
            Vector3d z = orientation.transform(new Vector3d(0, 0, 1));
            double skew = Math.max(Math.abs(x.dot(y)), Math.max(Math.abs(y.dot(z)), Math.abs(z.dot(x))));
            double volume = Math.abs(x.cross(y).dot(z) - 1);
            worstBasis = Math.max(worstBasis, Math.max(skew, volume));
        }

        ProofResult result(long count) {
            double off = place.distance(firstPlace);
            double turned = Math.abs(Math.abs(orientation.dot(firstOrientation)) - 1);
            List<String> failures = new ArrayList<>();
            if (!(off <= PLACE_BAR_METRES)) {
                failures.add("the body is " + off + " m from its place");
            }
            if (!(worstSpeed <= SPEED_BAR)) {
                failures.add("its speed is off by " + worstSpeed);
            }
            if (!(worstBasis <= BASIS_BAR) || !(turned <= BASIS_BAR)) {
                failures.add("its axes are off by " + Math.max(worstBasis, turned));
            }
            return new ProofResult(
                    count,
                    failures.size(),
                    List.of(
                            Figure.greatest("distance from its place", off, "m"),
                            Figure.greatest("speed off, of itself", worstSpeed, ""),
                            Figure.greatest("axes off orthonormal", worstBasis, "")),
                    failures);
        }
    }
}
