package nephele.engine.render.pass.terrain;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.View;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.EnumSource.Mode;

/**
 * A terrain with billboards, seen through a portal or in a mirror, equals the picture of the moved eye: billboards are turned
 * to that eye, and tiles are as fine as it needs.
 */
class GroundThroughOpeningsGlTest {
    private static final int SIZE = 128;
    private static final double HALF = 3;
    private static final Vec3 ENTRY = new Vec3(40, 18, 400);
    private static final Vec3 EXIT = new Vec3(-12, 16, 3);
    private static final TestAssets ASSETS = TestTerrain.map(70, TestTerrain::wavy)
            .picture("card.png", 16, 16, (x, y) -> x < 8 ? 0xff2010 : 0x10e020 + 8 * y);

    private static RenderSettings settings(PortalTechnique technique) {
        Quality quality = Quality.HIGH
                .with("portalTechnique", technique)
                .with("portalResolution", 1)
                .with("terrainErrorPixels", 3);
        return RenderSettings.of(Output.PLAIN, quality).with(Decoration.OFF);
    }

    private static TestLevel lit() {
        return new TestLevel()
                .ambient(0.3)
                .sun(new Vec3(0.4, 0.7, 0.5), 2)
                .material("low", new Vec3(0.2, 0.5, 0.1))
                .material(new Material("silver", new Vec3(1, 1, 1), null, null, null, null, Vec3.ZERO, 1, true));
    }

    private static Level ground(TestLevel level) {
        Facing[] facings = {Facing.CYLINDRICAL, Facing.SPHERICAL, Facing.CROSSED};
        for (int i = 0; i < 12; i++) {
            Vec3 foot = new Vec3(-8 + 5.0 * (i % 4), 7, -9 + 6.0 * (i / 4));
            level.billboards(Billboards.at("b" + i, "card.png", facings[i % 3], 2, 2.5, List.of(foot)));
        }
        Terrain.Layer everywhere = Terrain.Layer.everywhere("low");
        return level.level().withTerrains(List.of(TestTerrain.said("t", "map.r16", everywhere)));
    }

    private static int differing(int[] a, int[] b, boolean[] compared) {
        int count = 0;
        for (int i = 0; i < a.length; i++) {
            boolean isNear = Math.abs(Offscreen.red(a[i]) - Offscreen.red(b[i])) <= 2
                    && Math.abs(Offscreen.green(a[i]) - Offscreen.green(b[i])) <= 2
                    && Math.abs(Offscreen.blue(a[i]) - Offscreen.blue(b[i])) <= 2;
            count += compared[i] && !isNear ? 1 : 0;
        }
        return count;
    }

    /** Returns the pixels whose rays pass a square across z, well within its edges. */
    private static boolean[] through(Offscreen offscreen, View view, Vec3 centre) {
        boolean[] inside = new boolean[SIZE * SIZE];
        int count = 0;
        for (int i = 0; i < inside.length; i++) {
            Vec3 ray = offscreen.ray(view, i);
            Vec3 at = ray.scaled((centre.z() - view.eyeZ()) / ray.z())
                    .plus(view.eye())
                    .minus(centre);
            inside[i] = ray.z() < 0 && Math.abs(at.x()) < HALF - 0.2 && Math.abs(at.y()) < HALF - 0.2;
            count += inside[i] ? 1 : 0;
        }
        assertTrue(count > SIZE * SIZE / 4, count + " pixels");
        return inside;
    }

    private static Vec3 exitFromEntry(Vec3 place) {
        Vec3 d = place.minus(ENTRY);
        return EXIT.plus(new Vec3(-d.z(), d.y(), d.x()));
    }

    @ParameterizedTest
    @EnumSource(
            value = PortalTechnique.class,
            names = {"STENCIL", "TEXTURE"},
            mode = Mode.INCLUDE)
    void aPortalShowsWhatTheMovedEyeSees(PortalTechnique technique) {
        Level open = ground(lit());
        Level led = ground(lit().portal("a", "b", ENTRY, new Vec3(0, 0, 1), 2 * HALF, 2 * HALF)
                .portal("b", "a", EXIT, new Vec3(1, 0, 0), 2 * HALF, 2 * HALF));
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            Vec3 eye = ENTRY.plus(new Vec3(0.4, 2, 3));
            Vec3 target = ENTRY.plus(new Vec3(0, -0.6, 0));
            View view = offscreen.view(eye, target);
            View moved = offscreen.view(exitFromEntry(eye), exitFromEntry(target));
            int[] seen = offscreen.pixels(led, ASSETS, view, settings(technique));
            int[] expected = offscreen.pixels(open, ASSETS, moved, settings(technique));
            int differing = differing(expected, seen, through(offscreen, view, ENTRY));
            assertTrue(differing <= 12, differing + " pixels differ");
        }
    }

    @ParameterizedTest
    @EnumSource(
            value = PortalTechnique.class,
            names = {"STENCIL", "TEXTURE"},
            mode = Mode.INCLUDE)
    void aMirrorShowsWhatTheReflectedEyeSees(PortalTechnique technique) {
        Vec3 middle = new Vec3(0, 16, -14);
        Solid box = new Solid.Box(
                "mirror",
                "low",
                false,
                TextureMapping.WORLD,
                middle.plus(new Vec3(0, 0, -0.5)),
                new Vec3(2 * HALF, 2 * HALF, 1),
                Map.of(BoxFace.PLUS_Z, new Solid.Face("silver", null, null)));
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            Vec3 eye = middle.plus(new Vec3(0.5, 2, 3));
            View view = offscreen.view(eye, middle.plus(new Vec3(0, -0.6, 0)));
            View reflected = offscreen.view(middle.plus(new Vec3(0.5, 2, -3)), middle.plus(new Vec3(0, -0.6, 0)));
            int[] seen = offscreen.pixels(ground(lit().solid(box)), ASSETS, view, settings(technique));
            int[] behind = offscreen.pixels(ground(lit()), ASSETS, reflected, settings(technique));
            int[] expected = new int[behind.length];
            for (int i = 0; i < behind.length; i++) {
                expected[i] = behind[i / SIZE * SIZE + SIZE - 1 - i % SIZE];
            }
            int differing = differing(expected, seen, through(offscreen, view, middle));
            assertTrue(differing <= 12, differing + " pixels differ");
        }
    }
}
