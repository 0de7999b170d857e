package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.LongStream;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/**
 * Drops piles of boxes, balls and capsules, a third of them above or beside portals, and checks their energy. A unit is
 * a pile; its number is the seed.
 */
public final class EnergyProof implements Proof {
    /** The fraction of all piles that may exceed the limit of 1 mm. */
    private static final double MOST_LITTLE_GAINS = .001;
    /** The fraction of the piles without portals that may end awake. */
    private static final double MOST_AWAKE = .001;

    private static final int AT_ONCE = 64;

    private static final double DEEP_METRES = .01;
    private static final double SECONDS = 10;
    private static final double SETTLED_SECONDS = 1;
    private static final int DEPTH_EVERY_TICKS = 10;
    private static final Vec3 GRAVITY = new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0);

    private static final String PILES = "piles";
    private static final String VIOLATIONS = "violations";
    /** Piles with frozen bodies or advances cut short; neither gains energy, but both are failures. */
    private static final String FAULTY = "piles with faults";

    private static final String LITTLE = "violations at 1 mm";
    private static final String DEEP = "piles deeper than 1 cm";
    private static final String PLAIN = "piles without portals";
    private static final String AWAKE = "awake";

    @Override
    public Claim claim() {
        return new Claim(
                "energy",
                "Piles of one to four boxes, balls and capsules of 1 mm to 2.5 m and 1 g to 1 t, dropped for 10 s at"
                    + " 20 to 1000 ticks a second, a third of them at portals, seeds 0 to 99,999: E(t) is never above"
                    + " the least earlier E + 1e-5 of the greatest + m g 1 cm, and above it with 1 mm for at most 0.1"
                    + " %; from 1 s on none is deeper than 1 cm in a solid (every tenth tick); without portals at most"
                    + " 0.1 % end awake but for what rolls or spins.",
                "piles",
                100_000,
                2_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        for (long unit = from; unit < from + count; unit += AT_ONCE) {
            long end = Math.min(from + count, unit + AT_ONCE);
            List<ProofResult> some = LongStream.range(unit, end)
                    .parallel()
                    .mapToObj(number -> new Run(DroppedPile.of(number)).result())
                    .toList();
            for (ProofResult one : some) {
                one.examples().forEach(progress::failed);
                result = result.and(one);
            }
            progress.unitsDone(end - from);
        }
        return result;
    }

    /** Judges the limits that are fractions of all piles. */
    @Override
    public ProofResult judged(ProofResult soFar) {
        List<String> failures = new ArrayList<>(soFar.examples());
        long more = judge(soFar, LITTLE, PILES, MOST_LITTLE_GAINS, failures)
                + judge(soFar, AWAKE, PLAIN, MOST_AWAKE, failures);
        return new ProofResult(soFar.units(), soFar.failures() + more, soFar.figures(), failures);
    }

    private static long judge(ProofResult result, String some, String of, double most, List<String> failures) {
        double count = result.value(some);
        double all = result.value(of);
        if (count <= most * all) {
            return 0;
        }
        failures.add(0, String.format(Locale.ROOT, "%s: %.0f of %.0f", some, count, all));
        return (long) count;
    }

    /**
     * A run of a dropped pile over ten seconds. Its energy is checked at every tick, and its depth in solids at every tenth
     * tick after the first second.
     */
    private static final class Run {
        private final DroppedPile pile;
        private final PortalWorld world;
        private final EnergyLedger ledger;
        private final EnergyLimits limits;
        private final BodyDepth depth;
        private final RestDetector judge;
        private final Vector3d centre = new Vector3d();
        private double deepest;
        private int deepestTick;
        private double deepestInBody;
        private int faults;
        private int faultTick;

        Run(DroppedPile pile) {
            this.pile = pile;
            world = pile.world();
            ledger = new EnergyLedger(pile.table(), world.portals(), 1.0 / pile.ticksPerSecond());
            limits = new EnergyLimits(pile.table());
            depth = new BodyDepth(pile.table(), world);
            judge = new RestDetector(pile.table(), world.statics());
        }

        ProofResult result() {
            RigidStep step = new RigidStep(pile.table(), GRAVITY);
            BodyInfluences nobody = BodyInfluences.none();
            Bodies bodies = Bodies.of(pile.starts());
            limits.start(ledger.joules(bodies));
            int last = (int) Math.round(SECONDS * pile.ticksPerSecond());
            for (int tick = 1; tick <= last; tick++) {
                Bodies next = step.step(bodies, world, nobody, 1.0 / pile.ticksPerSecond());
                // The same object is returned if all bodies sleep; the step then depends on nothing that could change.
                boolean isOver = next == bodies || tick == last;
                ledger.book(bodies, next);
                limits.record(tick, ledger.joules(next));
                countFaults(tick, next, step);
                bodies = next;
                if (!pile.hasPortals()
                        && (isOver || tick > (SECONDS - RestDetector.WATCHED_SECONDS) * pile.ticksPerSecond())) {
                    judge.observe(bodies);
                }
                boolean settled = tick >= SETTLED_SECONDS * pile.ticksPerSecond();
                if (isOver || settled && tick % DEPTH_EVERY_TICKS == 0) {
                    measureDepth(tick, bodies);
                }
                if (isOver) {
                    break;
                }
            }
            return result(bodies);
        }

        private void countFaults(int tick, Bodies bodies, RigidStep step) {
            int now = bodies.frozen() + step.cutShort();
            faultTick = faults == 0 && now > 0 ? tick : faultTick;
            faults = Math.max(faults, now);
        }

        private void measureDepth(int tick, Bodies bodies) {
            for (int i = 0; i < bodies.size(); i++) {
                double metres = Math.max(depth.inSolids(bodies, i), pile.outsideMetres(bodies.centre(i, centre)));
                if (!(metres <= deepest)) {
                    deepest = metres;
                    deepestTick = tick;
                }
                deepestInBody = Math.max(deepestInBody, depth.inBodies(bodies, i));
            }
        }

        private ProofResult result(Bodies end) {
            boolean rests = pile.hasPortals() || judge.isAtRest(end);
            boolean isDeep = !(deepest <= DEEP_METRES);
            List<String> failures = new ArrayList<>();
            limits.failure().ifPresent(failure -> failures.add(pile.inWords() + ": " + failure));
            add(faults > 0, "%d faults from tick %d on", faults, faultTick, failures);
            add(isDeep, "%.3f mm in a solid at tick %d", deepest * 1000, deepestTick, failures);
            if (!rests) {
                failures.add(pile.inWords() + ": does not rest");
            }
            String where = "mm in pile " + pile.number();
            List<Figure> figures = List.of(
                    Figure.sum(PILES, 1, ""),
                    Figure.sum(VIOLATIONS, limits.gains() ? 1 : 0, ""),
                    Figure.sum(FAULTY, faults > 0 ? 1 : 0, ""),
                    Figure.sum(LITTLE, limits.gainsLittle() ? 1 : 0, ""),
                    Figure.greatest("deepest", deepest * 1000, where),
                    Figure.sum(DEEP, isDeep ? 1 : 0, ""),
                    Figure.greatest("deepest in another body", deepestInBody * 1000, where),
                    Figure.sum(PLAIN, pile.hasPortals() ? 0 : 1, ""),
                    Figure.sum(AWAKE, rests ? 0 : 1, ""),
                    Figure.sum("bodies through portals", ledger.crossings(), "times"));
            int count = (limits.gains() ? 1 : 0) + (faults > 0 ? 1 : 0) + (isDeep ? 1 : 0);
            return new ProofResult(1, count, figures, failures);
        }

        private void add(boolean fails, String format, Object amount, int tick, List<String> failures) {
            if (fails) {
                failures.add(pile.inWords() + ": " + String.format(Locale.ROOT, format, amount, tick));
            }
        }
    }
}
