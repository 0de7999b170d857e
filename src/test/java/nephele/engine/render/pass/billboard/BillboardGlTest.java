package nephele.engine.render.pass.billboard;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.billboard.FacingAxes;
import nephele.engine.level.billboard.PlantedBillboards;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.View;
import nephele.host.draw.IdLevel;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Pictures of billboards against rays through their twin's squares, and what must not change them. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class BillboardGlTest {
    private static final int SIZE = 64;
    private static final int SKY = 0x0000ff;
    private static final int LEFT = 0xff0000;
    private static final int RIGHT = 0x00ff00;
    private static final Vec3 FOOT = new Vec3(0.5, -1, -4);
    private static final List<Vec3> EYES = List.of(
            new Vec3(0, 0.3, 0),
            new Vec3(4.2, 1.5, -3.1),
            new Vec3(-2, 0.2, -7.5),
            new Vec3(1.5, -3, -4.2),
            new Vec3(0.5, 4, -4.01));

    private final Offscreen offscreen = new Offscreen(SIZE, SIZE);
    private final TestAssets assets = new TestAssets()
            .picture("card.png", 16, 16, (x, y) -> x < 8 ? LEFT : RIGHT)
            .picture("keyed.png", 32, 32, (x, y) -> Math.hypot(x - 15.5, y - 15.5) < 12 ? 0x20c040 : 0xff00ff)
            .seeThroughPicture("veil.png", 8, 8, (x, y) -> 0x80ff0000)
            .seeThroughPicture("green-veil.png", 8, 8, (x, y) -> 0x8000ff00);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static TestLevel level() {
        return new TestLevel().sky(new Sky.Constant(new Vec3(0, 0, 1))).ambient(1);
    }

    private static Billboards card(Facing facing, Vec3 foot) {
        return Billboards.at("b", "card.png", facing, 2, 2.4, List.of(foot));
    }

    private int[] plain(Level level, View view) {
        return offscreen.pixels(level, assets, view, RenderSettings.of(Output.PLAIN));
    }

    private static Vec3 middle(Vec3 foot) {
        return foot.plus(new Vec3(0, 1.2, 0));
    }

    /** Returns what a ray sees, nearest image first. */
    private int expected(Facing facing, View view, int pixel, double turn) {
        int seen = SKY;
        double nearest = Double.POSITIVE_INFINITY;
        for (int image = 0; image < (facing == Facing.CROSSED ? 2 : 1); image++) {
            Vec3 toMiddle = middle(FOOT).minus(view.eye());
            FacingAxes axes =
                    FacingAxes.of(facing, toMiddle.negated(), view.right(), view.up(), turn + image * Math.PI / 2);
            Vec3 ray = offscreen.ray(view, pixel);
            double distance = toMiddle.dot(axes.front()) / ray.dot(axes.front());
            Vec3 at = ray.scaled(distance).minus(toMiddle);
            double x = at.dot(axes.right());
            if (distance > 0 && distance < nearest && Math.abs(x) < 1 && Math.abs(at.dot(axes.up())) < 1.2) {
                nearest = distance;
                seen = x < 0 ? LEFT : RIGHT;
            }
        }
        return seen;
    }

    @ParameterizedTest
    @EnumSource(Facing.class)
    void isDrawnWhereItsTwinIs(Facing facing) {
        Level level = level().billboards(card(facing, FOOT)).level();
        double turn = new PlantedBillboards.Group(level.billboards().get(0), List.of(FOOT)).turn(0);
        for (Vec3 eye : EYES) {
            View view = offscreen.view(eye, middle(FOOT));
            int[] drawn = plain(level, view);
            int wrong = 0;
            int covered = 0;
            for (int i = 0; i < drawn.length; i++) {
                int expected = expected(facing, view, i, turn);
                covered += expected == SKY ? 0 : 1;
                wrong += drawn[i] == expected ? 0 : 1;
            }
            assertTrue(covered > 10
                    || facing == Facing.CYLINDRICAL
                    || facing == Facing.CROSSED
                    || facing == Facing.SOURCE);
            // The texture's middle and the borders are as uncertain as a pixel.
            assertTrue(wrong < 70, facing + " from " + eye + ": " + wrong + " of " + covered);
        }
    }

    @Test
    void aMillionMetresAwayThePictureIsTheSame() {
        Vec3 far = new Vec3(1 << 20, 0, -(1 << 20));
        for (Facing facing : new Facing[] {Facing.SPHERICAL, Facing.CYLINDRICAL, Facing.SCREEN}) {
            int[] near =
                    plain(level().billboards(card(facing, FOOT)).level(), offscreen.view(EYES.get(0), middle(FOOT)));
            Level moved = level().box(null, far, new Vec3(0.01, 0.01, 0.01))
                    .billboards(card(facing, FOOT.plus(far)))
                    .level();
            int[] there = plain(
                    moved, offscreen.view(EYES.get(0).plus(far), middle(FOOT).plus(far)));
            int differing = 0;
            for (int i = 0; i < near.length; i++) {
                differing += near[i] == there[i] ? 0 : 1;
            }
            assertTrue(differing < 12, facing + ": " + differing);
        }
    }

    /** Magenta is the key: no pixel holds any of it, near the edge and far away. */
    @Test
    void aColourKeyLeavesNoFringe() {
        Billboards keyed = new Billboards(
                "k",
                "keyed.png",
                new Vec3(1, 0, 1),
                Facing.SCREEN,
                new Billboards.Size(3, 3),
                0,
                List.of(new Vec3(0, -1.5, -2.2), new Vec3(-6, 3, -22), new Vec3(9, 1, -24)),
                null,
                1,
                0,
                0,
                false,
                Vec3.ZERO,
                null);
        int[] drawn = plain(level().billboards(keyed).level(), offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1)));
        assertTrue(Arrays.stream(drawn).anyMatch(rgb -> Offscreen.green(rgb) > 0xb0));
        assertTrue(Arrays.stream(drawn).allMatch(rgb -> Offscreen.red(rgb) <= 0x24));
    }

    private static Billboards veil(String id, String sprite, double z) {
        return Billboards.at(id, sprite, Facing.SCREEN, 2, 2, List.of(new Vec3(0, -1, z)))
                .asBlended();
    }

    private int middlePixel(Billboards first, Billboards second) {
        Level level = level().billboards(first).billboards(second).level();
        return plain(level, offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1)))[SIZE / 2 * SIZE + SIZE / 2];
    }

    @Test
    void blendedOnesAreDrawnFromTheFarthestInWhateverOrderTheyAreWritten() {
        int seen = middlePixel(veil("near", "veil.png", -2), veil("far", "green-veil.png", -3));
        assertEquals(seen, middlePixel(veil("far", "green-veil.png", -3), veil("near", "veil.png", -2)));
        assertEquals(0x80, Offscreen.red(seen), 2);
        assertEquals(0x40, Offscreen.green(seen), 2);
    }

    @Test
    void atEqualDistancesTheOrderOfTheLevelHolds() {
        int seen = middlePixel(veil("a", "veil.png", -2), veil("b", "green-veil.png", -2));
        assertEquals(0x40, Offscreen.red(seen), 2);
        assertEquals(0x80, Offscreen.green(seen), 2);
    }

    /** A wall a tenth of a metre behind a veil shows more of itself than one that is farther away than the veil fades. */
    @Test
    void blendedOnesFadeWhereASurfaceCutsThem() {
        Level far = beforeAWall(5);
        Level near = beforeAWall(0.1);
        assertEquals(0.5, redOfRadiance(far), 0.01);
        // 0.1 m of the 0.3 m over which a veil of 2 m fades.
        assertEquals(0.5 / 3, redOfRadiance(near), 0.02);
    }

    /** Plain output costs no copy of the view's depth. */
    @Test
    void theyDoNotFadeInPlainOutput() {
        View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1));
        assertEquals(0x80, Offscreen.red(plain(beforeAWall(0.1), view)[SIZE / 2 * SIZE + SIZE / 2]), 3);
    }

    private float redOfRadiance(Level level) {
        View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1));
        return offscreen.radiance(level, assets, view)[3 * (SIZE / 2 * SIZE + SIZE / 2)];
    }

    private Level beforeAWall(double metres) {
        return level().material("blue", new Vec3(0, 0, 1))
                .box("blue", new Vec3(0, 0, -4 - metres), new Vec3(40, 40, 2))
                .billboards(veil("veil", "veil.png", -3))
                .level();
    }

    /** Lamps light billboards also where there is nothing else. */
    @Test
    void aLampLightsThemInAnEmptyLevel() {
        TestLevel dark = new TestLevel().ambient(0.1).billboards(card(Facing.SPHERICAL, FOOT));
        View view = offscreen.view(EYES.get(0), middle(FOOT));
        int middle = 3 * (SIZE / 2 * SIZE + SIZE / 2 + 3) + 1;
        float unlit = offscreen.radiance(dark.level(), assets, view)[middle];
        Light lamp = new Light.Point("l", EYES.get(0), TestLevel.grey(100), 50, false);
        assertTrue(offscreen.radiance(dark.light(lamp).level(), assets, view)[middle] > 3 * unlit);
    }

    @Test
    void identityColoursAreFlatAndTheGroupsOwn() {
        Level ids =
                IdLevel.of(level().billboards(card(Facing.CYLINDRICAL, FOOT)).level());
        int[] drawn = plain(ids, offscreen.view(EYES.get(0), middle(FOOT)));
        assertArrayEquals(
                new int[] {0, IdLevel.colour(0)},
                Arrays.stream(drawn).distinct().sorted().toArray());
    }

    @Test
    void groundIsShadedByThem() {
        TestLevel lit = new TestLevel()
                .castingSun(new Vec3(1, 1, 0), 3)
                .ambient(0.1)
                .box(null, new Vec3(0, -1.5, -4), new Vec3(20, 1, 20));
        View view = offscreen.view(new Vec3(0, 4, 2), new Vec3(0, -1, -6));
        float[] bare = offscreen.radiance(lit.level(), assets, view);
        float[] shaded = offscreen.radiance(
                lit.billboards(card(Facing.CYLINDRICAL, new Vec3(0, -1, -4))).level(), assets, view);
        int darker = 0;
        for (int i = 0; i < bare.length; i += 3) {
            boolean isGrey = shaded[i] == shaded[i + 1] && shaded[i] == shaded[i + 2];
            darker += isGrey && shaded[i] < 0.3f * bare[i] ? 1 : 0;
        }
        assertTrue(darker > 20, darker + " shaded pixels");
    }

    /** Several samples a pixel smooth the edge: some pixels are mixtures. */
    @Test
    void samplesAreCoveredByAlpha() {
        Quality four = Quality.HIGH.with("samples", 4);
        Level level = level().billboards(
                        Billboards.at("k", "keyed.png", Facing.SCREEN, 3, 3, List.of(new Vec3(0, -1.5, -2.2))))
                .level();
        View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1));
        int[] drawn = offscreen.pixels(
                level, assets, view, RenderSettings.of(Output.PLAIN).with(four));
        assertTrue(Arrays.stream(drawn).distinct().count() > 2);
    }
}
