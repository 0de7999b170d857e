package nephele.engine.sim.carry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.sim.Lab;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.PortalOpened;
import nephele.engine.sim.state.ViewAngles;
import nephele.engine.sim.state.WorldState;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Bodies and player in portals that move never end in a solid. */
@Execution(ExecutionMode.CONCURRENT)
final class PortalOccupantsTest {
    private static final double EDGE = 0.5;

    private SimLevel level;
    private PortalWorld.Cache worlds;

    private static Lab withCubeAt(Lab lab, Vec3 centre) {
        Bodies bodies = lab.state().world().bodies();
        Vec3 still = Vec3.ZERO;
        var moved = new BodyState(centre, new Quaterniond(), still, still);
        return lab.set(lab.state().with(lab.state().world().with(bodies.with(0, moved))));
    }

    /**
     * The side of a cube's centre decides where it goes when its portal moves; a cube in the other portal stays where
     * it is.
     */
    @Test
    void aCubeInAMovedPortalIsPutOnTheCentresSide() {
        for (double before : new double[] {0.002, 0.1, 0.2}) {
            for (Action shot : new Action[] {Action.FIRE_FIRST, Action.FIRE_SECOND}) {
                Lab lab = withCubeAt(Lab.twoPortals(EDGE), new Vec3(0, EDGE / 2, -8 + before))
                        .hold(PlayerInput.NONE, 0.3);
                assertEquals(-8 + before, lab.body(0).z(), 1e-3);
                lab.turn(90, 0).tick(PlayerInput.NONE.holding(shot));
                assertInstanceOf(PortalOpened.class, lab.events().get(2));
                assertTrue(deepest(lab) < 0.002, "in a solid by " + deepest(lab));
                lab.hold(PlayerInput.NONE, 0.5);
                double expected = shot == Action.FIRE_FIRST ? EDGE / 2 : before;
                assertEquals(-8 + expected, lab.body(0).z(), 2e-3, before + " " + shot);
                assertEquals(EDGE / 2, lab.body(0).y(), 2e-3);
                assertTrue(deepest(lab) < 0.002, "in a solid by " + deepest(lab));
            }
        }
    }

    /** A portal that opens under a sleeping cube wakes it, and it falls. */
    @Test
    void aPortalUnderASleepingCubeLetsItFall() {
        Lab lab = Lab.hall()
                .gun()
                .cube(new Vec3(0, EDGE / 2 + 0.001, -2), EDGE, 10)
                .cube(new Vec3(6, EDGE / 2 + 0.001, 6), EDGE, 10)
                .startAt(0, 0, 0, 90, -5)
                .press(Action.FIRE_FIRST)
                .hold(PlayerInput.NONE, 2);
        assertTrue(lab.state().world().bodies().isAsleep(0));
        // Aimed beside the cube, where the portal still reaches under it.
        lab.turn(-90, 5 - 50.5);
        lab.press(Action.FIRE_SECOND);
        assertInstanceOf(PortalOpened.class, lab.events().get(1), lab.events().toString());
        lab.hold(PlayerInput.NONE, 1.5);
        assertTrue(lab.body(0).x() < -5, "out of the wall to the left: " + lab.body(0));
        assertEquals(6, lab.body(1).x(), 1e-3);
    }

    /** Random input, half a minute each, in rooms where portals fit nearly everywhere, leaves nothing in a solid. */
    @Test
    void whateverIsPressedNobodyEndsInASolid() {
        int opened = 0;
        int carried = 0;
        for (int seed = 0; seed < 2; seed++) {
            var random = new SplittableRandom(seed);
            Lab lab = Lab.hall()
                    .gun()
                    .box(-3, 0, -6, -1, 2, -4)
                    .box(2, 0, 2, 6, 1, 4)
                    .cube(new Vec3(0, 0.3, -2), 0.6, 20);
            for (int i = 0; i < 16; i++) {
                double[] ring = {-6, -2, 2, 6};
                lab.cube(new Vec3(ring[i / 4] + 0.1, 1.3, ring[i % 4] - 0.1), 0.4, 5);
            }
            level = null;
            for (int i = 0; i < 150; i++) {
                PlayerInput input = anything(random);
                int up = -random.nextInt(60_000) - lab.player().heading().pitchMillidegrees();
                lab.tick(input.turning(random.nextInt(-60_000, 60_001), i % 4 == 0 ? 2 * up : up));
                lab.hold(input, 0.1);
                if (i % 3 == 0) {
                    faceNearest(lab);
                    lab.press(Action.CARRY);
                }
                assertTrue(
                        deepest(lab) < 0.01,
                        "seed " + seed + ", tick " + lab.state().tick() + ": " + deepest(lab));
                assertInside(lab.player().centre(), 0.2);
            }
            opened +=
                    lab.events().stream().filter(PortalOpened.class::isInstance).count();
            carried += lab.events().stream()
                    .filter(TickEvent.Handled.class::isInstance)
                    .count();
            assertEquals(0, lab.state().faults());
        }
        assertTrue(opened > 30 && carried > 15, opened + " portals, " + carried + " times in hands");
    }

    private static void faceNearest(Lab lab) {
        Vector3d eye = lab.player().eye().toVector();
        Vector3d nearest = new Vector3d(100, 0, 0);
        for (int i = 0; i < lab.state().world().bodies().size(); i++) {
            Vector3d to = lab.body(i).toVector().sub(eye);
            nearest.set(to.length() < nearest.length() ? to : nearest);
        }
        double yaw = Math.toDegrees(StrictMath.atan2(-nearest.x, -nearest.z));
        double pitch = Math.toDegrees(StrictMath.asin(nearest.y / nearest.length()));
        ViewAngles now = lab.player().heading();
        lab.turn(yaw - now.yawMillidegrees() / 1000.0, pitch - now.pitchMillidegrees() / 1000.0);
    }

    private static PlayerInput anything(SplittableRandom random) {
        int any = 1 << random.nextInt(Action.values().length);
        int actions = random.nextInt(3) == 0 ? Action.CARRY.bit() : any;
        return new PlayerInput(random.nextInt(2) * 60, random.nextInt(-1, 2) * 60, 0, 0, actions);
    }

    private static void assertInside(Vec3 p, double margin) {
        double most = 8 + margin;
        assertTrue(
                Math.abs(p.x()) < most && Math.abs(p.z()) < most && p.y() > -margin && p.y() < 6 + margin,
                p.toString());
    }

    /** Returns the greatest penetration of the player or a body into the solids near it. */
    private double deepest(Lab lab) {
        WorldState around = lab.state().world();
        if (level == null) {
            level = SimLevel.of(lab.level());
            worlds = new PortalWorld.Cache(level.statics());
        }
        PortalWorld space = worlds.of(around.portals());
        PlayerState player = lab.player();
        double depth = depth(
                space,
                player.stance().shape(player.tilt().up()),
                player.centre().toVector());
        BodyTable table = level.bodies();
        for (int i = 0; i < around.bodies().size(); i++) {
            RoundedHull hull = table.hull(i, around.bodies().orientation(i, new Quaterniond()));
            Vector3d centre = around.bodies().centre(i, new Vector3d());
            assertInside(Vec3.of(centre), 0.05);
            depth = Math.max(depth, depth(space, hull, centre));
        }
        return depth;
    }

    private static double depth(PortalWorld space, RoundedHull shape, Vector3d at) {
        CollisionWorld world = space.openedFor(space.active(shape, at, new Vector3d()));
        var near = new ItemList();
        world.overlapping(
                new Aabb(
                        at.x + shape.least(0),
                        at.y + shape.least(1),
                        at.z + shape.least(2),
                        at.x + shape.greatest(0),
                        at.y + shape.greatest(1),
                        at.z + shape.greatest(2)),
                near);
        var separation = new Separation();
        double depth = 0;
        for (int i = 0; i < near.size(); i++) {
            separation.measure(shape, at.x, at.y, at.z, world.collider(near.get(i)));
            depth = Math.max(depth, -separation.metres());
        }
        return depth;
    }
}
