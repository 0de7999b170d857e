package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.Body;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Level;
import nephele.engine.level.Level.Observer;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.Solid;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.model.bound.Bound;
import nephele.engine.render.Offscreen;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A receiver outside what the sun's map covers is lit, and one behind its casters is shaded, whatever casts. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class OutsideShadowMapGlTest {
    private static final int SIZE = 40;
    private static final Vec3 SUN = new Vec3(0.3, 0.8, 0.4);
    private static final double SLOPE = 0.3;

    private final Offscreen offscreen = new Offscreen(SIZE, SIZE);
    private final TestAssets assets = new TestAssets().seeThroughPicture("card.png", 8, 8, (x, y) -> 0xff808080);

    @AfterAll
    void close() {
        offscreen.close();
    }

    /** What stands on a ground, {@code u} metres high, at a place. */
    enum Caster {
        BILLBOARD {
            @Override
            Level on(TestLevel ground, Vec3 at, double u) {
                return ground.billboards(card(Facing.CYLINDRICAL, u, at)).level();
            }
        },
        CROSSED_CLUSTER {
            @Override
            Level on(TestLevel ground, Vec3 at, double u) {
                return ground.billboards(card(Facing.CROSSED, u, at, beside(at, u), beside(at, -u)))
                        .level();
            }
        },
        OBSERVED_BILLBOARDS {
            @Override
            Level on(TestLevel ground, Vec3 at, double u) {
                return ground.billboards(card(Facing.CROSSED, u, at))
                        .level()
                        .with(new PlayerStart(at.plus(new Vec3(100, 0, 1e5)), 0, 0), null)
                        .withObserver(new Observer(null, 0.5, Bound.SPHERE));
            }
        },
        IMPOSTOR {
            @Override
            Level on(TestLevel ground, Vec3 at, double u) {
                return ground.impostor("cone_1_3_6_1.3d", null, scaled(u), moved(at))
                        .level();
            }
        },
        MODEL {
            @Override
            Level on(TestLevel ground, Vec3 at, double u) {
                return ground.model("torus_1_0.45_24_12.3d", null, scaled(u / 2), moved(at.plus(new Vec3(0, u / 2, 0))))
                        .level();
            }
        },
        POST_THROUGH_THE_GROUND {
            @Override
            Level on(TestLevel ground, Vec3 at, double u) {
                return ground.box(null, at, new Vec3(u / 2, 2 * u, u / 2)).level();
            }
        },
        SLAB_ABOVE {
            @Override
            Level on(TestLevel ground, Vec3 at, double u) {
                return ground.box(null, at.plus(new Vec3(0, 2 * u, 0)), new Vec3(u, u / 100, u))
                        .level();
            }
        },
        BODIES {
            @Override
            Level on(TestLevel ground, Vec3 at, double u) {
                return ground.box(null, at, new Vec3(u / 2, 2 * u, u / 2))
                        .body(body("near", at.plus(new Vec3(-u, u, 0)), u))
                        .body(body("far", at.plus(new Vec3(-6 * u, 0.5 * u, 5 * u)), u))
                        .level();
            }
        };

        abstract Level on(TestLevel ground, Vec3 at, double u);

        private static Body body(String id, Vec3 at, double u) {
            return new Body.Box(id, at, TestLevel.grey(u / 2), 1, null, 0, 0);
        }

        private static Vec3 beside(Vec3 at, double metres) {
            return new Vec3(at.x() + metres, at.y(), at.z());
        }

        private static Billboards card(Facing facing, double u, Vec3... feet) {
            return Billboards.at("b", "card.png", facing, u, u, List.of(feet));
        }

        private static TransformStep scaled(double u) {
            return new TransformStep.Scale(TestLevel.grey(u));
        }

        private static TransformStep moved(Vec3 by) {
            return new TransformStep.Translate(by);
        }
    }

    /** What stands in the middle, in a corner and on a slope of a ground of each size. */
    @ParameterizedTest
    @EnumSource(Caster.class)
    void isLitUnlessSomethingShadesIt(Caster caster) {
        isLikeTheReference(caster, flat(1), Vec3.ZERO, 0.25, 1);
        onSlope(caster, 100);
        inCorner(caster, 10_000);
    }

    /** The same for one kind in steps of a decade. */
    @ParameterizedTest
    @ValueSource(doubles = {10, 100, 1000, 10_000})
    void isLitWhateverTheSizeOfTheGround(double side) {
        isLikeTheReference(Caster.BILLBOARD, flat(side), Vec3.ZERO, 3, side);
        inCorner(Caster.BILLBOARD, side);
    }

    private void inCorner(Caster caster, double side) {
        isLikeTheReference(caster, flat(side), new Vec3(0.4 * side, 0, -0.4 * side), height(side), side);
    }

    private void onSlope(Caster caster, double side) {
        Vec3 at = new Vec3(-0.1 * side, (0.5 - 0.1) * SLOPE * side, 0.3 * side);
        isLikeTheReference(caster, sloping(side), at, height(side), side);
    }

    /** A thousandth of the ground is more than a texel of the map, where that holds the whole ground. */
    private static double height(double side) {
        return Math.max(Math.min(3, side / 20), side / 1000);
    }

    /** A roof is as thin as the least depth of the map, whose texels are 25 cm. */
    @Test
    void isShadedBeyondTheFarthestCaster() {
        TestLevel under = new TestLevel()
                .castingSun(new Vec3(0, 1, 0), Math.PI)
                .box(null, new Vec3(0, -1, 0), new Vec3(1000, 1, 1000))
                .box(null, new Vec3(0, 50, 0), new Vec3(1000, 0.01, 1000))
                .body(new Body.Box("body", new Vec3(0, 2, 0), TestLevel.grey(3), 1, null, 0, 0));
        float[] drawn = offscreen.radiance(under.level(), assets, above(Vec3.ZERO, 8, 1000));
        assertEquals(1, darkShare(drawn));
    }

    private static TestLevel stage() {
        return new TestLevel().castingSun(SUN, Math.PI);
    }

    private static TestLevel flat(double side) {
        return stage().box(null, new Vec3(0, -side / 20, 0), new Vec3(side, side / 10, side));
    }

    private static TestLevel sloping(double side) {
        return stage().solid(new Solid.Wedge(
                "slope",
                null,
                false,
                TextureMapping.WORLD,
                new Vec3(0, SLOPE * side / 2, 0),
                new Vec3(side, SLOPE * side, side),
                BoxFace.PLUS_X,
                Map.of()));
    }

    /**
     * Compares the shares of shaded pixels from above the ground and from above the caster.
     *
     * @param u the caster's height
     * @param side of the ground
     */
    private void isLikeTheReference(Caster caster, TestLevel ground, Vec3 at, double u, double side) {
        Level level = caster.on(ground, at, u);
        TracedLevel traced = TracedLevel.of(PlacedLevel.of(level, assets), ColourDecoding.SRGB);
        List<View> views = List.of(above(Vec3.ZERO, side, side), above(at, 3 * u, side));
        List<float[]> drawn = offscreen.radiance(level, assets, views);
        for (int i = 0; i < views.size(); i++) {
            float[] wanted = ReferencePicture.trace(
                    traced, pinhole(views.get(i)), new TraceSettings(SIZE, SIZE, 1, 1, 1), done -> {});
            String what = caster + " on " + side + " m, view " + i;
            assertEquals(darkShare(wanted), darkShare(drawn.get(i)), i == 0 ? 0.015 : 0.03, what);
        }
    }

    private static Pinhole pinhole(View view) {
        double half = view.projection().tanHalfWidth();
        return new Pinhole(
                view.eye(),
                new Basis(view.right(), view.up(), view.back()),
                half,
                half,
                view.projection().nearMetres(),
                view.projection().farMetres());
    }

    private static View above(Vec3 at, double width, double side) {
        return View.lookAt(
                at.plus(new Vec3(0.02 * width, 1.5 * width, 0)),
                at,
                new Vec3(0, 0, -1),
                new Projection(2 * Math.atan(1 / 3.0), 1, width / 100, 4 * side));
    }

    private static double darkShare(float[] radiance) {
        int dark = 0;
        for (int i = 0; i < radiance.length; i += 3) {
            dark += radiance[i] < 0.2 ? 1 : 0;
        }
        return dark / (double) (radiance.length / 3);
    }
}
