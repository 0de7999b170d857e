package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.View;
import nephele.host.draw.IdLevel;
import nephele.lab.bake.TracedPictures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** The oracle's billboards beside drawn ones, by identity. */
class BillboardShapeTest {
    private static final int SIZE = 64;
    private static final Vec3 FOOT = new Vec3(0.3, -1, -4);
    private static final Vec3 EYE = new Vec3(0.1, 0.6, 0);

    private final TestAssets assets =
            new TestAssets().seeThroughPicture("disc.png", 64, 64, (x, y) -> isInDisc(x, y) ? 0xff808080 : 0);

    private static boolean isInDisc(int x, int y) {
        return Math.hypot(x - 31.5, y - 31.5) < 28;
    }

    private static Level level(Facing facing) {
        Billboards disc = Billboards.at("b", "disc.png", facing, 2, 2, List.of(FOOT));
        return new TestLevel()
                .box(null, new Vec3(0, -1.5, -4), new Vec3(20, 1, 20))
                .billboards(disc)
                .level();
    }

    /** Crossed ones are the same squares in both; the others face rays instead of the eye, which moves their rim a little. */
    @ParameterizedTest
    @EnumSource(Facing.class)
    void isWhereThePictureHasIt(Facing facing) {
        Level level = level(facing);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(EYE, FOOT.plus(new Vec3(0, 1, 0)));
            int[] drawn = offscreen.pixels(IdLevel.of(level), assets, view, RenderSettings.of(Output.PLAIN));
            Basis basis = new Basis(view.right(), view.up(), view.back());
            Pinhole eye = new Pinhole(EYE, basis, 1, 1, 0.05, 1000);
            VisibleSurface sight = TracedLevel.of(PlacedLevel.of(level, assets), ColourDecoding.AS_STORED)
                    .sight(eye);
            int wrong = 0;
            int covered = 0;
            for (int i = 0; i < drawn.length; i++) {
                int seen = sight.at((i % SIZE + 0.5) / SIZE, (i / SIZE + 0.5) / SIZE);
                covered += seen == 1 ? 1 : 0;
                wrong += IdLevel.surface(drawn[i]) == seen || drawn[i] == 0 && seen < 0 ? 0 : 1;
            }
            assertTrue(covered > 80, covered + " covered");
            assertTrue(wrong <= (facing == Facing.CROSSED || facing == Facing.SOURCE ? 12 : 40), wrong + " wrong");
        }
    }

    @Test
    void shadesTheGround() {
        Level level = level(Facing.CYLINDRICAL);
        TracedLevel traced = TracedLevel.of(PlacedLevel.of(level, assets), ColourDecoding.AS_STORED);
        Pinhole above = new Pinhole(
                new Vec3(0.3, 6, -5),
                new Basis(new Vec3(1, 0, 0), new Vec3(0, 0, -1), new Vec3(0, 1, 0)),
                1,
                1,
                0.05,
                1000);
        VisibleSurface sight = traced.sight(above);
        assertEquals(0, sight.at(0.5, 0.5));
        assertEquals(false, sight.isLit(Vec3.ZERO, new Vec3(0, 1, 1), Double.POSITIVE_INFINITY));
        assertEquals(true, sight.isLit(Vec3.ZERO, new Vec3(0, 1, -1), Double.POSITIVE_INFINITY));
    }

    /** The picture has the light of four corners, linear between them: less than that of a ball before the sun. */
    @ParameterizedTest
    @CsvSource({"0.2, 0.5, 1", "-1, 0.3, 0.1", "1, 0.2, 0.4", "0.1, 0.3, -1", "0, 1, 0"})
    void isAsBrightAsDrawnWhereverTheSunIs(double x, double y, double z) {
        Level level = new TestLevel()
                .box(null, new Vec3(0, -1.5, -4), new Vec3(20, 1, 20))
                .sun(new Vec3(x, y, z), 3)
                .billboards(Billboards.at("b", "disc.png", Facing.CYLINDRICAL, 2, 2, List.of(FOOT)))
                .level();
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(EYE, FOOT.plus(new Vec3(0, 1, 0)));
            TracedLevel traced = TracedLevel.of(PlacedLevel.of(level, assets), ColourDecoding.SRGB);
            boolean[] within = within(
                    traced.sight(new Pinhole(EYE, new Basis(view.right(), view.up(), view.back()), 1, 1, 0.05, 1000)));
            double drawn = mean(offscreen.radiance(level, assets, view), within);
            var settings = new TraceSettings(SIZE, SIZE, 4, 1, 2);
            double exact =
                    mean(ReferencePicture.trace(traced, TracedPictures.pinhole(view), settings, done -> {}), within);
            assertEquals(exact, drawn, 0.2 * exact + 0.004);
        }
    }

    /** Returns for each pixel whether it and all beside it show the disc. */
    private static boolean[] within(VisibleSurface sight) {
        var within = new boolean[SIZE * SIZE];
        for (int i = 0; i < within.length; i++) {
            boolean isWithin = true;
            for (int neighbour = 0; neighbour < 9; neighbour++) {
                double x = (i % SIZE + neighbour % 3 - 0.5) / SIZE;
                double y = (i / SIZE + neighbour / 3 - 0.5) / SIZE;
                isWithin &= sight.at(x, y) == 1;
            }
            within[i] = isWithin;
        }
        return within;
    }

    private static double mean(float[] radiance, boolean[] within) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < within.length; i++) {
            sum += within[i] ? radiance[3 * i] : 0;
            count += within[i] ? 1 : 0;
        }
        return sum / count;
    }
}
