package nephele.engine.scene.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.level.Brush;
import nephele.engine.level.Light;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector4d;
import org.junit.jupiter.api.Test;

public class ShadowTest {
    @Test
    void everyCasterLiesInsideTheMapWithItsMargin() {
        List<Brush> brushes = List.of(box(0, 1, 0, 2, 2, 2), box(9, 0.5, -4, 1, 1, 8));
        for (Vec3 sun :
                List.of(new Vec3(0.3, 0.8, -0.5), new Vec3(0, 5, 0), new Vec3(1, 0, 0), new Vec3(0, -1, 1e-3))) {
            List<Vec3> corners =
                    brushes.stream().flatMap(b -> b.shape().vertices().stream()).toList();
            ShadowFrame frame = ShadowFrame.fit(corners, sun, new Vec3(1, 2, 3), 2048);
            for (Vec3 c : corners) {
                Vector3d m = frame.mapFromAnchor().transformPosition(new Vector3d(c.x() - 1, c.y() - 2, c.z() - 3));
                assertTrue(m.x * frame.width() >= 2 && m.x * frame.width() <= frame.width() - 2, "column " + m);
                assertTrue(m.y * frame.height() >= 2 && m.y * frame.height() <= frame.height() - 2, "row " + m);
                assertTrue(m.z > 0 && m.z < 1, "depth " + m);
            }
            assertTrue(frame.width() <= 2048 && frame.height() <= frame.width());
            assertEquals(
                    0,
                    new Vector3d(frame.right().toVector())
                            .cross(frame.up().toVector())
                            .distance(sun.toVector().normalize()),
                    1e-12);
        }
    }

    @Test
    void aGroundBehindEverythingNeedNotCast() {
        Brush ground = box(0, -0.5, 0, 1000, 1, 1000);
        Brush house = box(0, 1, 0, 4, 2, 4);
        assertEquals(List.of(house), ShadowCasters.of(List.of(ground, house), new Vec3(1, 1, 0)));
        Brush cellar = box(0, -5, 0, 2, 2, 2);
        assertEquals(
                2,
                ShadowCasters.of(List.of(ground, house, cellar), new Vec3(1, 1, 0))
                        .size());
    }

    @Test
    void aMapSmallerThanItsMarginsIsStillAMap() {
        for (int side = 1; side <= 7; side++) {
            List<Vec3> corners = box(0, 1, 0, 2, 2, 2).shape().vertices();
            ShadowFrame frame = ShadowFrame.fit(corners, new Vec3(1, 1, 0), Vec3.ZERO, side);
            assertTrue(frame.texelMetres() > 0 && frame.texelMetres() < 10, "texel " + frame.texelMetres());
            assertTrue(frame.width() <= 7 && frame.height() <= 7);
        }
    }

    /** The casters equal those of a comparison of every solid with every other. */
    @Test
    void castersAreThoseOfTheDefinition() {
        SplittableRandom random = new SplittableRandom(5);
        Vec3 sun = new Vec3(0.4, 1, -0.3);
        int all = 0;
        int casting = 0;
        for (int round = 0; round < 200; round++) {
            List<Brush> brushes = new ArrayList<>();
            for (int i = 0; i < 1 + round % 12; i++) {
                brushes.add(box(random.nextInt(9), random.nextInt(5), random.nextInt(9), 1 + random.nextInt(9), 1, 2));
            }
            List<Brush> expected =
                    brushes.stream().filter(b -> !isBehindAll(b, brushes, sun)).toList();
            assertEquals(expected, ShadowCasters.of(brushes, sun));
            assertEquals(!expected.isEmpty(), ShadowCasters.any(brushes, sun));
            all += brushes.size();
            casting += expected.size();
        }
        assertTrue(casting > all / 10 && casting < all * 19 / 20, casting + " of " + all);
    }

    private static boolean isBehindAll(Brush brush, List<Brush> brushes, Vec3 sun) {
        return brush.shape().faces().stream()
                .map(face -> face.plane())
                .filter(p -> p.nx() * sun.x() + p.ny() * sun.y() + p.nz() * sun.z() > 0)
                .anyMatch(plane -> brushes.stream()
                        .allMatch(other -> other == brush
                                || other.shape().vertices().stream().allMatch(v -> plane.signedDistance(v) >= -1e-6)));
    }

    /** The six pictures of a point light cover all directions and overlap by two texels at the edges. */
    @Test
    void cubeLayersOverlapByTheirGuardBand() {
        List<PunctualLight> lights =
                List.of(PunctualLight.of(new Light.Point("p", new Vec3(5, 6, 7), new Vec3(1, 1, 1), 10, true))
                        .orElseThrow());
        LightShadowLayers shadows = LightShadowLayers.of(lights);
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 1000; i++) {
            Vector3d d = new Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
            int axis = d.maxComponent();
            int layer = 2 * axis + (d.get(axis) < 0 ? 1 : 0);
            Matrix4d clip = shadows.clipFromAnchor(lights, layer, new Vec3(1, 1, 1));
            Vector4d c = clip.transform(new Vector4d(d.x + 4, d.y + 5, d.z + 6, 1));
            double limit = 1 - 4.0 / shadows.side() + 1e-9;
            assertTrue(c.w > 0 && Math.abs(c.x) <= limit * c.w && Math.abs(c.y) <= limit * c.w, d + " → " + c);
        }
    }

    @Test
    void spotLayerCoversItsCone() {
        Light.Spot spot =
                new Light.Spot("s", new Vec3(0, 3, 0), new Vec3(1, -2, 0.5), new Vec3(1, 1, 1), 9, 20, 35, true);
        List<PunctualLight> lights = List.of(PunctualLight.of(spot).orElseThrow());
        PunctualLightTable table =
                PunctualLightTable.of(List.of(spot), new Aabb(-5, 0, -5, 5, 3, 5), StaticShapes.of(List.of()));
        assertEquals(1, table.shadows().layers().size());
        Vector3d axis = lights.get(0).axis().toVector();
        Vector3d side = LightShadowLayers.right(lights.get(0));
        assertEquals(0, side.dot(axis), 1e-12);
        Vector3d rim = new Vector3d(axis).mul(Math.cos(Math.toRadians(35))).fma(Math.sin(Math.toRadians(35)), side);
        Vector4d c =
                table.shadows().clipFromAnchor(lights, 0, new Vec3(0, 3, 0)).transform(new Vector4d(rim, 1));
        assertEquals(1 - 4.0 / table.shadows().side(), c.x / c.w, 1e-9, "the cone's rim lies two texels inside");
    }

    public static Brush box(double x, double y, double z, double width, double height, double depth) {
        return Brush.of(new Solid.Box(
                "box", null, false, TextureMapping.WORLD, new Vec3(x, y, z), new Vec3(width, height, depth), Map.of()));
    }
}
