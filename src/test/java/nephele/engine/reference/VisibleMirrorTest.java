package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Rays off mirrors hit the right surfaces, and the mirrors tint their radiance. */
class VisibleMirrorTest {
    private static final Vec3 TINT = new Vec3(0.5, 0.6, 0.8);
    private static final Vec3 RED = new Vec3(0.9, 0.2, 0.1);

    private static TestLevel stage() {
        return new TestLevel()
                .ambient(1)
                .material("red", RED)
                .material("blue", new Vec3(0.1, 0.2, 0.9))
                .material(new Material("mirror", TINT, null, null, null, null, Vec3.ZERO, 1, true));
    }

    private static void assertRadiance(Vec3 expected, float[] seen) {
        assertEquals(expected.x(), seen[0], 1e-6);
        assertEquals(expected.y(), seen[1], 1e-6);
        assertEquals(expected.z(), seen[2], 1e-6);
    }

    private static Vec3 red(int mirrors) {
        return new Vec3(
                RED.x() * Math.pow(TINT.x(), mirrors),
                RED.y() * Math.pow(TINT.y(), mirrors),
                RED.z() * Math.pow(TINT.z(), mirrors));
    }

    /** The path leads straight back to the wall behind the eye, and off two perpendicular mirrors to the same wall. */
    @Test
    void eachMirrorMultipliesByItsColour() {
        TestLevel room = stage().box("mirror", new Vec3(0, 0, -3.1), new Vec3(8, 8, 0.2))
                .box("red", new Vec3(0, 0, 5.1), new Vec3(8, 8, 0.2));
        assertRadiance(red(1), Traced.towards(room, Vec3.ZERO, new Vec3(0.1, 0.1, -1), 1));
        room.box("mirror", new Vec3(4.1, 0, 0), new Vec3(0.2, 8, 6));
        assertRadiance(red(2), Traced.towards(room, new Vec3(2, 0, 0), new Vec3(3, 0, -2), 1));
    }

    /** The path leads through a portal onto a mirror, and back through the same portal. */
    @Test
    void aMirrorBehindAPortal() {
        TestLevel rooms = stage().box("red", new Vec3(0, 0, 5.1), new Vec3(8, 8, 0.2))
                .box("mirror", new Vec3(100, 0, -3.1), new Vec3(8, 8, 0.2))
                .portal("a", "b", new Vec3(0, 0, -1), new Vec3(0, 0, 1), 1, 2)
                .portal("b", "a", new Vec3(100, 0, -1), new Vec3(0, 0, -1), 1, 2);
        assertRadiance(red(1), Traced.towards(rooms, Vec3.ZERO, new Vec3(0, 0, -1), 1));
    }

    /** Fog in front of the mirror keeps its colour, fog behind it is tinted. */
    @Test
    void fogBeforeAMirrorIsNotTinted() {
        double extinction = 0.2;
        TestLevel room = stage().fog(extinction, new Vec3(0.4, 0.4, 0.4))
                .box("mirror", new Vec3(0, 0, -3.1), new Vec3(8, 8, 0.2))
                .box("red", new Vec3(0, 0, 5.1), new Vec3(8, 8, 0.2));
        double before = Math.exp(-3 * extinction);
        double behind = Math.exp(-8 * extinction);
        double expected = 0.4 * (1 - before) + before * TINT.x() * (0.4 * (1 - behind) + behind * RED.x());
        assertEquals(expected, Traced.towards(room, Vec3.ZERO, new Vec3(0, 0, -1), 1)[0], 1e-6);
    }

    /** A mirror reflects no light onto other surfaces: they are lit as beside a black wall. */
    @Test
    void mirrorsLightNothing() {
        TestLevel dark = stage().castingSun(new Vec3(0, 1, 0), 2).box("red", Vec3.ZERO, new Vec3(4, 0.2, 4));
        TestLevel bright = stage().castingSun(new Vec3(0, 1, 0), 2).box("red", Vec3.ZERO, new Vec3(4, 0.2, 4));
        Solid.Face mirror = new Solid.Face("mirror", null, null);
        bright.solid(new Solid.Box(
                "wall",
                "blue",
                false,
                TextureMapping.WORLD,
                new Vec3(0, 2, -2.1),
                new Vec3(4, 4, 0.2),
                Map.of(BoxFace.PLUS_Z, mirror)));
        Vec3 eye = new Vec3(0, 3, 1);
        Vec3 floor = new Vec3(0, 0.1, 0.5);
        float[] without = Traced.towards(dark, eye, floor, 1);
        float[] with = Traced.towards(bright, eye, floor, 1);
        for (int i = 0; i < 3; i++) {
            assertEquals(without[i], with[i], 0);
        }
    }
}
