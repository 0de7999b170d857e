package nephele.engine.collision.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Boxes and balls thrown in a closed room stay in it, for any speed and angular velocity and thin walls. */
@Execution(ExecutionMode.CONCURRENT)
class FastBodiesTest {
    private static final double ROOM_HALF_METRES = 2;
    private static final double SECONDS = 2;

    @ParameterizedTest
    @CsvSource({
        "30, 0.02, 900", "30, 0.2, 900", "60, 0.02, 500", "60, 0.2, 500",
        "120, 0.02, 200", "120, 0.2, 200", "240, 0.02, 100", "240, 0.2, 100"
    })
    void nothingLeavesAClosedRoom(int ticksPerSecond, double wallMetres, int throwsOfIt) {
        PortalWorld room = PortalWorld.of(room(wallMetres));
        List<String> outside = new ArrayList<>();
        for (int i = 0; i < throwsOfIt; i++) {
            var random = new SplittableRandom(1000L * ticksPerSecond + i);
            Body body = body(random);
            BodyState start = start(random);
            Bodies after =
                    run(new RigidStep(new BodyTable(List.of(body)), BodyScene.GRAVITY), room, start, ticksPerSecond);
            Vector3d centre = after.centre(0, new Vector3d());
            if (!(centre.absolute().get(centre.maxComponent()) < ROOM_HALF_METRES) || after.frozen() > 0) {
                outside.add(i + ": " + body + " from " + start + " to " + after.state(0));
            }
        }
        assertEquals(0, outside.size(), () -> outside.size() + " outside, first " + outside.get(0));
    }

    private static Bodies run(RigidStep step, PortalWorld room, BodyState start, int ticksPerSecond) {
        Bodies bodies = Bodies.of(List.of(start));
        BodyInfluences nothing = BodyInfluences.none();
        for (int tick = 0; tick < SECONDS * ticksPerSecond; tick++) {
            bodies = step.step(bodies, room, nothing, 1.0 / ticksPerSecond);
        }
        return bodies;
    }

    private static CollisionWorld room(double wallMetres) {
        double in = ROOM_HALF_METRES;
        double out = in + wallMetres;
        List<Collider> walls = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            double[] least = {-out, -out, -out};
            double[] greatest = {out, out, out};
            if (i < 3) {
                greatest[i] = -in;
            } else {
                least[i - 3] = in;
            }
            var box = new Aabb(least[0], least[1], least[2], greatest[0], greatest[1], greatest[2]);
            walls.add(new Collider("w" + i, ConvexPolyhedron.box(box)));
        }
        return new CollisionWorld(walls);
    }

    private static Body body(SplittableRandom random) {
        double cube = random.nextDouble(0.1, 0.8);
        if (random.nextInt(8) == 0) {
            return new Body.Sphere("ball", Vec3.ZERO, cube / 2, 10, null, 0.6, 0.4);
        }
        Vec3 size = new Vec3(cube, cube, random.nextInt(3) > 0 ? cube : random.nextDouble(0.1, 0.8));
        return new Body.Box("box", Vec3.ZERO, size, 10, null, 0.6, random.nextInt(2) == 0 ? 0.2 : 0.9);
    }

    private static BodyState start(SplittableRandom random) {
        Vec3 to = direction(random, StrictMath.pow(10, random.nextDouble(StrictMath.log10(5), StrictMath.log10(200))));
        Vec3 spin = direction(random, random.nextDouble(0, 50));
        Vec3 from = direction(random, random.nextDouble(0, 1.2));
        var turn = Rotations.aroundAxis(direction(random, 1), random.nextDouble(0, 3));
        return new BodyState(from, turn, to, spin);
    }

    private static Vec3 direction(SplittableRandom random, double length) {
        var d = new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        return Vec3.of(d.normalize(length));
    }
}
