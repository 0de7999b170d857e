package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerDimensions;
import org.joml.Vector3d;

/** A light cube under a heavy load that is then removed. */
final class LoadedStack {
    static final double SUNK_METRES = .001;
    static final double FAST_METRES_PER_SECOND = 5;
    private static final double UNLOADED_SECONDS = 1;
    private static final double GAP_METRES = .002;
    private static final double FRICTION = .6;
    private static final Vec3 GRAVITY = new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0);

    private final PortalWorld world = PortalWorld.of(BoxPile.closedRoom(6, 8, 1), Portals.NONE);
    private final Vector3d velocity = new Vector3d();
    private double sleepsDeep;
    private double fastest;

    /**
     * The results of a stack.
     *
     * @param sleepsDeepMetres greatest depth in the floor or in another body at which a body slept
     * @param fastestMetresPerSecond of any body at any tick, with the load and without
     * @param sunkMetres depth of the lowest body in the floor, 1 s after the others are removed
     */
    record Seen(double sleepsDeepMetres, double fastestMetresPerSecond, double sunkMetres) {
        boolean holds() {
            return sleepsDeepMetres <= SUNK_METRES
                    && fastestMetresPerSecond <= FAST_METRES_PER_SECOND
                    && sunkMetres <= SUNK_METRES;
        }
    }

    /** Returns a cube of 1 t and 1 m on a cube of 1 g and 5 cm. */
    static List<Body> tonneOnGram() {
        return List.of(cube(0, .025, .05, .001), cube(1, .05 + GAP_METRES + .5, 1, 1000));
    }

    /**
     * Returns twelve cubes of 40 cm, each {@code ratio} times as heavy as the one below; their geometric mean is 10 kg.
     */
    static List<Body> tower(double ratio) {
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

    static Seen run(List<Body> bodies, int ticksPerSecond, double seconds) {
        return new LoadedStack().seen(bodies, ticksPerSecond, seconds);
    }

    private Seen seen(List<Body> bodies, int rate, double seconds) {
        BodyTable loaded = new BodyTable(bodies);
        Bodies end = move(loaded, loaded.start(), rate, seconds);
        BodyTable lowest = new BodyTable(bodies.subList(0, 1));
        Bodies unloaded = move(lowest, Bodies.of(List.of(end.state(0))), rate, UNLOADED_SECONDS);
        return new Seen(sleepsDeep, fastest, new BodyDepth(lowest, world).inSolids(unloaded, 0));
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
