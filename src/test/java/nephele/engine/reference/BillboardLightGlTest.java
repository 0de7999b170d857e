package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Light that varies over a large or near billboard is where it should be, not where two triangles put it. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Order(1) // one of the longest
class BillboardLightGlTest {
    private static final int SIZE = 48;
    private static final Vec3 EYE = new Vec3(0, 1, 3);

    private final Offscreen offscreen = new Offscreen(SIZE, SIZE);
    private final TestAssets assets = new TestAssets().seeThroughPicture("card.png", 8, 8, (x, y) -> 0xffc08040);

    @AfterAll
    void close() {
        offscreen.close();
    }

    /** What lights a level; {@code side} is 1 or −1, the level of one is the mirror image of that of the other. */
    enum Lit {
        LAMP {
            @Override
            TestLevel of(double side) {
                return new TestLevel()
                        .light(new Light.Point("p", new Vec3(side, 1.5, -2.2), TestLevel.grey(5), 20, true));
            }
        },
        SUN_BEHIND_A_POST {
            @Override
            TestLevel of(double side) {
                return new TestLevel()
                        .castingSun(new Vec3(0.5 * side, 0.6, 0.4), 3)
                        .box(null, new Vec3(1.3 * side, 1.5, -2), new Vec3(0.6, 3, 0.6));
            }
        },
        SKY {
            @Override
            TestLevel of(double side) {
                return new TestLevel()
                        .skyLight()
                        .sky(new Sky.Gradient(new Vec3(0.4, 0.6, 1), TestLevel.grey(0.8), TestLevel.grey(0.1)));
            }
        },
        FOG {
            @Override
            TestLevel of(double side) {
                return new TestLevel().ambient(0.7).fog(0.3, new Vec3(0.2, 0.5, 0.9));
            }
        },
        AIR {
            @Override
            TestLevel of(double side) {
                return new TestLevel().sky(Sky.Atmosphere.CLEAR).skyLight().sun(new Vec3(0.5 * side, 0.6, 0.4), 3);
            }
        };

        abstract TestLevel of(double side);
    }

    /** Returns a ground with two billboards, the nearer one of which the picture cuts. */
    private static TestLevel stage(TestLevel level, double side, Facing facing, boolean isBlended) {
        Billboards cards = Billboards.at(
                "b", "card.png", facing, 1.2, 2, List.of(new Vec3(0.3 * side, 0, -3), new Vec3(-1.4 * side, 0, 0.8)));
        return level.box(null, new Vec3(0, -0.15, 0), new Vec3(20, 0.3, 20))
                .billboards(isBlended ? cards.asBlended() : cards);
    }

    private View view() {
        return offscreen.view(EYE, new Vec3(0, 1, -5));
    }

    @ParameterizedTest
    @EnumSource(Lit.class)
    void aMirroredLevelIsAMirroredPicture(Lit lit) {
        for (Facing facing : List.of(Facing.SPHERICAL, Facing.CYLINDRICAL, Facing.SCREEN)) {
            boolean isBlended = facing == Facing.SPHERICAL;
            float[] right = drawn(stage(lit.of(1), 1, facing, isBlended).level());
            float[] left = drawn(stage(lit.of(-1), -1, facing, isBlended).level());
            for (int i = 0; i < SIZE * SIZE; i++) {
                int mirrored = i / SIZE * SIZE + SIZE - 1 - i % SIZE;
                float expected = right[3 * mirrored];
                String where = lit + ", " + facing + ", pixel " + i % SIZE + ", " + i / SIZE;
                assertEquals(expected, left[3 * i], 0.003 * expected + 1e-4, where);
            }
        }
    }

    private float[] drawn(Level level) {
        return offscreen.radiance(level, assets, view());
    }

    /** The reference lights each pixel for itself; it turns billboards to each ray, which moves edges. */
    @ParameterizedTest
    @CsvSource({"LAMP, 0.1", "SUN_BEHIND_A_POST, 0.1", "FOG, 0.01", "AIR, 0.1"})
    void isLitAsTheReferenceTraces(Lit lit, double tolerance) {
        Level level = stage(lit.of(1), 1, Facing.CYLINDRICAL, false).level();
        float[] drawn = drawn(level);
        View view = view();
        var eye = new Pinhole(EYE, new Basis(view.right(), view.up(), view.back()), 1, 1, 0.05, 1000);
        TracedLevel traced = TracedLevel.of(PlacedLevel.of(level, assets), ColourDecoding.SRGB);
        float[] wanted = ReferencePicture.trace(traced, eye, new TraceSettings(SIZE, SIZE, 1, 1, 1), done -> {});
        double difference = 0;
        double sum = 0;
        for (int i = 0; i < SIZE * SIZE; i++) {
            if (isOnBillboard(i % SIZE, i / SIZE)) {
                difference += Math.abs(drawn[3 * i] - wanted[3 * i]);
                sum += wanted[3 * i];
            }
        }
        assertEquals(0, difference / sum, tolerance);
    }

    /** Returns true well within one of the two billboards. */
    private static boolean isOnBillboard(int x, int y) {
        return x > 23 && x < 27 && y > 20 && y < 28 || x > 3 && x < 14 && y > 14 && y < 34;
    }
}
