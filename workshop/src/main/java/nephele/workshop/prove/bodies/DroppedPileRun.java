package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions;
import org.joml.Vector3d;

/**
 * A run of a dropped pile over ten seconds. Its energy is checked at every tick, and its depth in solids at every tenth
 * tick after the first second.
 */
public final class DroppedPileRun {
    static final double DEEP_METRES = .01;
    private static final double SECONDS = 10;
    private static final double SETTLED_SECONDS = 1;
    private static final int DEPTH_EVERY_TICKS = 10;
    private static final Vec3 GRAVITY = new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0);

    private final DroppedPile pile;
    private final PortalWorld world;
    private final EnergyLedger ledger;
    private final EnergyLimits bars;
    private final BodyDepth depth;
    private final RestDetector judge;
    private final Vector3d centre = new Vector3d();
    private double deepest;
    private int deepestTick;
    private double deepestInBody;
    private int faults;
    private int faultTick;

    private DroppedPileRun(DroppedPile pile) {
        this.pile = pile;
        world = pile.world();
        ledger = new EnergyLedger(pile.table(), world.portals(), 1.0 / pile.ticksPerSecond());
        bars = new EnergyLimits(pile.table());
        depth = new BodyDepth(pile.table(), world);
        judge = new RestDetector(pile.table(), world.statics());
    }

    /**
     * The results of a pile.
     *
     * @param gains energy above the limit of 1 cm of the pile's height
     * @param gainsLittle energy above the limit of 1 mm
     * @param faults bodies frozen and advances cut short
     * @param deepestMetres depth in a solid or out of the room after the first second; {@code deepestInBodyMetres}
     *     likewise
     * @param rests whether it ended at rest; judged only without portals, otherwise true
     * @param failures in words, with tick and amount
     */
    public record Seen(
            boolean gains,
            boolean gainsLittle,
            boolean hasPortals,
            int faults,
            double deepestMetres,
            double deepestInBodyMetres,
            boolean rests,
            long crossings,
            List<String> failures) {}

    public static Seen run(DroppedPile pile) {
        return new DroppedPileRun(pile).run();
    }

    private Seen run() {
        RigidStep step = new RigidStep(pile.table(), GRAVITY);
        BodyInfluences nobody = BodyInfluences.none();
        Bodies bodies = Bodies.of(pile.starts());
        bars.start(ledger.joules(bodies));
        int last = (int) Math.round(SECONDS * pile.ticksPerSecond());
        for (int tick = 1; tick <= last; tick++) {
            Bodies next = step.step(bodies, world, nobody, 1.0 / pile.ticksPerSecond());
            // The same object is returned if all bodies sleep; the step then depends on nothing that could change.
            boolean isOver = next == bodies || tick == last;
            ledger.book(bodies, next);
            bars.record(tick, ledger.joules(next));
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
        return seen(bodies);
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

    private Seen seen(Bodies end) {
        boolean rests = pile.hasPortals() || judge.isAtRest(end);
        List<String> failures = new ArrayList<>();
        bars.failure().ifPresent(failure -> failures.add(pile.inWords() + ": " + failure));
        add(faults > 0, "%d faults from tick %d on", faults, faultTick, failures);
        add(!(deepest <= DEEP_METRES), "%.3f mm in a solid at tick %d", deepest * 1000, deepestTick, failures);
        if (!rests) {
            failures.add(pile.inWords() + ": does not rest");
        }
        return new Seen(
                bars.gains(),
                bars.gainsLittle(),
                pile.hasPortals(),
                faults,
                deepest,
                deepestInBody,
                rests,
                ledger.crossings(),
                failures);
    }

    private void add(boolean fails, String format, Object amount, int tick, List<String> failures) {
        if (fails) {
            failures.add(pile.inWords() + ": " + String.format(Locale.ROOT, format, amount, tick));
        }
    }
}
