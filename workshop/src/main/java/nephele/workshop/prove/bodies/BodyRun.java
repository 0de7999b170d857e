package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.workshop.art.bench.BenchBodies;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** A run of a level's bodies alone, which measures their distances from the expected places. */
final class BodyRun {
    private static final Vec3 GRAVITY = new Vec3(0, -9.81, 0);
    static final Environment DARK =
            new Environment(null, new Sky.Constant(Vec3.ZERO), null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());

    private final RigidStep step;
    private final PortalWorld surroundings;
    private final BodyInfluences nobody = new BodyInfluences();
    private final List<Vec3> places;
    private final Vector3d centre = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private Bodies bodies;

    private BodyRun(Level level, List<Vec3> places) {
        BodyTable table = BodyTable.of(level);
        step = new RigidStep(table, GRAVITY);
        surroundings = PortalWorld.of(CollisionWorld.of(level), Portals.of(level));
        bodies = table.start();
        this.places = places;
    }

    /** Returns a tower of unit boxes. */
    static BodyRun tower(int boxes) {
        Level plane = BenchBodies.stack(DARK);
        List<Body> bodies = new ArrayList<>();
        for (int i = 0; i < boxes; i++) {
            bodies.add(new Body.Box("t" + i, new Vec3(0, 0.5 + i, 0), new Vec3(1, 1, 1), 1, null, 0.6, 0));
        }
        return new BodyRun(
                plane.with(List.of(), plane.solids(), bodies),
                bodies.stream().map(Body::centre).toList());
    }

    /** Returns the 500 boxes of the benchmark stack; each is expected where the gaps below it are closed. */
    static BodyRun stack() {
        Level level = BenchBodies.stack(DARK);
        List<Vec3> places = new ArrayList<>();
        for (int i = 0; i < level.bodies().size(); i++) {
            Vec3 start = level.bodies().get(i).centre();
            places.add(new Vec3(start.x(), 0.5 + i / 25, start.z()));
        }
        return new BodyRun(level, places);
    }

    /** Returns the 200 bodies of the benchmark shaft, without expected places. */
    static BodyRun restless() {
        return new BodyRun(BenchBodies.shaft(DARK), List.of());
    }

    void tick(double seconds) {
        bodies = step.step(bodies, surroundings, nobody, seconds);
    }

    /** Returns the greatest distance of a body from its expected place, in metres. */
    double farthestOff() {
        double most = 0;
        for (int i = 0; i < places.size(); i++) {
            Vec3 place = places.get(i);
            most = Math.max(most, bodies.centre(i, centre).distance(place.x(), place.y(), place.z()));
        }
        return most;
    }

    /** Returns the greatest rotation of a body since the start, in degrees. */
    double mostTilted() {
        double most = 0;
        for (int i = 0; i < bodies.size(); i++) {
            bodies.orientation(i, turn);
            double sine = Math.sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
            most = Math.max(most, 2 * Math.toDegrees(StrictMath.asin(Math.min(1, sine))));
        }
        return most;
    }

    int asleep() {
        int count = 0;
        for (int i = 0; i < bodies.size(); i++) {
            count += bodies.isAsleep(i) ? 1 : 0;
        }
        return count;
    }

    long crossings() {
        long count = 0;
        for (int i = 0; i < bodies.size(); i++) {
            count += bodies.crossings(i);
        }
        return count;
    }
}
