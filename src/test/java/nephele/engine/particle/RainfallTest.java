package nephele.engine.particle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Emitter;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** A floor with a portal that faces up, outside; a room far away with its exit, in the ceiling or in a wall. */
class RainfallTest {
    private static final Vec3 RAIN_CENTRE = new Vec3(0, 4, 0);
    private static final Vec3 RAIN_SIZE = new Vec3(3, 8, 3);
    private static final Vec3 ROOM = new Vec3(40, 0, 0);
    private static final double NOW = 30;

    private static Level level(Vec3 exit, Vec3 normal) {
        return level(exit, normal, 0);
    }

    /** @param floor height of the floor outside, in or under which the portal lies at a hundredth of a metre */
    private static Level level(Vec3 exit, Vec3 normal, double floor) {
        return new TestLevel()
                .box(null, new Vec3(0, floor - 0.5, 0), new Vec3(20, 1, 20))
                .box(null, ROOM.plus(new Vec3(0, -0.5, 0)), new Vec3(20, 1, 20))
                .box(null, ROOM.plus(new Vec3(0, 4.5, 0)), new Vec3(20, 1, 20))
                .box(null, ROOM.plus(new Vec3(-5.5, 2, 0)), new Vec3(1, 4, 20))
                .portal("in", "out", new Vec3(0, 0.01, 0), new Vec3(0, 1, 0), 1.6, 1.6)
                .portal("out", "in", exit, normal, 1.6, 1.6)
                .level();
    }

    private static LevelParticles rain(Level level, boolean splashes) {
        Emitter emitter = new Emitter("rain", Emitter.Kind.RAIN, RAIN_CENTRE, RAIN_SIZE, 900, 3, -9, 0, 0, splashes);
        return new LevelParticles(List.of(emitter), StaticShapes.of(level));
    }

    private static int inRoom(ParticleArrays at) {
        int count = 0;
        for (int i = 0; i < at.count(); i++) {
            count += at.get(i, ParticleArrays.X) > 20 ? 1 : 0;
        }
        return count;
    }

    @Test
    void rainGoesOnFromTheCeilingWhereThePathLeads() {
        Level level = level(ROOM.plus(new Vec3(0, 3.99, 0)), new Vec3(0, -1, 0));
        LevelParticles rain = rain(level, false);
        Portals portals = Portals.of(level);
        rain.follow(portals);
        ParticleArrays at = rain.at(NOW);
        PathTrace trace = new PathTrace(portals, (from, way) -> 1);
        int through = 0;
        for (int i = 0; i < at.count(); i++) {
            Vector3d place = new Vector3d(
                    RAIN_CENTRE.x() + at.get(i, ParticleArrays.X),
                    RAIN_CENTRE.y() + at.get(i, ParticleArrays.Y),
                    RAIN_CENTRE.z() + at.get(i, ParticleArrays.Z));
            if (place.x > 20) {
                through++;
                assertTrue(rain.bounds(0).contains(place.x, place.y, place.z));
                // The same way backwards: the exit is entered upwards, and the drop was over the portal outside.
                trace.trace(place, new Vector3d(0, 6, 0));
                assertEquals(1, trace.crossings());
                assertEquals(0.01 + 6 - (3.99 - place.y), trace.place().y(), 0.01);
                assertTrue(Math.abs(trace.place().x()) < 0.8
                        && Math.abs(trace.place().z()) < 0.8);
            }
        }
        // The column holds drops evenly: 900 a second over 9 m², 2.56 m² of aperture, half a second of fall.
        assertEquals(900 * 2.56 / 9 * 0.5, through, 30);
    }

    @Test
    void aDropInTheRoomWasOverThePortalAMomentBefore() {
        Level level = level(ROOM.plus(new Vec3(0, 3.99, 0)), new Vec3(0, -1, 0));
        LevelParticles open = rain(level, false);
        open.follow(Portals.of(level));
        LevelParticles closed = rain(level, false);
        assertEquals(0, inRoom(closed.at(NOW)));
        int all = open.at(NOW).count();
        assertEquals(all - inRoom(open.at(NOW)), closed.at(NOW).count(), 6);
    }

    @Test
    void rainFromAWallFallsInACurveAndSplashesOnTheFloor() {
        Level level = level(ROOM.plus(new Vec3(-4.99, 2, 0)), new Vec3(1, 0, 0));
        LevelParticles rain = rain(level, true);
        rain.follow(Portals.of(level));
        ParticleArrays at = rain.at(NOW);
        int low = 0;
        int splashes = 0;
        for (int i = 0; i < at.count(); i++) {
            double x = RAIN_CENTRE.x() + at.get(i, ParticleArrays.X) - ROOM.x();
            double y = RAIN_CENTRE.y() + at.get(i, ParticleArrays.Y);
            if (x > -10) {
                assertTrue(x >= -5 && y > -0.03, "in a wall or the floor");
                boolean isSplash = at.get(i, ParticleArrays.LOOK) < 1;
                splashes += isSplash ? 1 : 0;
                low += y < 1 && !isSplash && x > -3 ? 1 : 0;
                assertTrue(!isSplash || y < 0.2, "splashes are on the floor");
            }
        }
        assertTrue(low > 5, low + " fall away from the wall");
        assertTrue(splashes > 5, splashes + " splashes");
    }

    private static int inRoom(Level level, Vec3 centre) {
        Emitter emitter = new Emitter("rain", Emitter.Kind.RAIN, centre, RAIN_SIZE, 900, 3, -9, 0, 0, false);
        LevelParticles rain = new LevelParticles(List.of(emitter), StaticShapes.of(level));
        rain.follow(Portals.of(level));
        return inRoom(rain.at(NOW));
    }

    /** A portal that is flush with a surface is met before it, by 0.3 m either way: of the floor, and of the box's end. */
    @Test
    void rainMeetsAPortalWithinTheFlushOfTheFloorAndOfItsBox() {
        Vec3 ceiling = ROOM.plus(new Vec3(0, 3.99, 0));
        Vec3 down = new Vec3(0, -1, 0);
        int through = inRoom(level(ceiling, down), RAIN_CENTRE);
        assertTrue(through > 80, through + " at the floor");
        assertEquals(through, inRoom(level(ceiling, down, 0.25), RAIN_CENTRE), "a little below the floor");
        assertEquals(0, inRoom(level(ceiling, down, 0.4), RAIN_CENTRE), "under the floor");
        Vec3 above = new Vec3(0, 4.25, 0);
        assertTrue(inRoom(level(ceiling, down), above) > 80, "a box that ends a little above the portal");
        assertEquals(0, inRoom(level(ceiling, down), new Vec3(0, 4.4, 0)), "a box that ends above the portal");
        assertEquals(0, inRoom(level(ceiling, down), new Vec3(0, -4.4, 0)), "a box below the portal");
    }
}
