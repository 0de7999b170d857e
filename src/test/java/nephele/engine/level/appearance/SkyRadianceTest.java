package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The sky of an atmosphere has no special axis but the vertical, and no seam at the horizon. */
@Execution(ExecutionMode.CONCURRENT)
class SkyRadianceTest {
    private static final List<Vec3> AXES = List.of(
            new Vec3(1, 0, 0),
            new Vec3(0, 0, 1),
            new Vec3(-1, 0, 0),
            new Vec3(0, 0, -1),
            new Vec3(0, 1, 0),
            new Vec3(0, -1, 0));

    private static SkyRadiance sky(Vec3 towardsSun) {
        Environment lit = new TestLevel()
                .sky(Sky.Atmosphere.CLEAR)
                .sun(towardsSun, 4)
                .level()
                .environment();
        return SkyRadiance.of(lit, id -> null, ColourDecoding.SRGB).orElseThrow();
    }

    private static Vector3d towards(SkyRadiance sky, double eyeHeight, Vec3 direction) {
        return sky.from(eyeHeight, direction.x(), direction.y(), direction.z());
    }

    /** With sun and eye along the six axes, light depends on heights and the angle around the vertical alone. */
    @Test
    void noAxisIsSpecialButTheVertical() {
        List<SkyRadiance> skies = AXES.stream().map(SkyRadianceTest::sky).toList();
        for (int sun = 0; sun < 6; sun++) {
            for (int eye = 0; eye < 6; eye++) {
                Vector3d seen = towards(skies.get(sun), 2, AXES.get(eye));
                int turn = sun < 4 ? sun : Math.min(eye, 3);
                Vector3d turned = towards(skies.get(turned(sun, turn)), 2, AXES.get(turned(eye, turn)));
                String what = "sun " + AXES.get(sun) + ", eye " + AXES.get(eye) + ": ";
                assertTrue(seen.isFinite() && seen.x >= 0 && seen.y >= 0 && seen.z >= 0, what + seen);
                assertEquals(0, turned.sub(seen).length(), 1e-6 * seen.length(), what + seen);
            }
        }
    }

    /** Returns the number of an axis that is turned around the vertical by so many right angles. */
    private static int turned(int axis, int rightAngles) {
        return axis < 4 ? Math.floorMod(axis - rightAngles, 4) : axis;
    }

    /** An eye in the air sees no jump at the level direction, where an elevation changes its sign. */
    @Test
    void theLevelDirectionIsNoSeam() {
        SkyRadiance sky = sky(new Vec3(0.6, 0.1, -0.8));
        for (double height : new double[] {100, 10_000, 80_000}) {
            Vector3d above = towards(sky, height, new Vec3(1, 1e-9, 0));
            Vector3d level = towards(sky, height, new Vec3(1, 0, 0));
            Vector3d below = towards(sky, height, new Vec3(1, -1e-9, 0));
            assertEquals(0, above.sub(level).length(), 1e-6 * level.length(), "above, from " + height);
            assertEquals(0, below.sub(level).length(), 1e-6 * level.length(), "below, from " + height);
        }
    }
}
