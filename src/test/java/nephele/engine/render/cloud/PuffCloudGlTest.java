package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.cloud.field.PuffsField;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.BillboardFacing;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Clouds that are divided into soft balls: particles and billboards. */
@TestInstance(Lifecycle.PER_CLASS)
class PuffCloudGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 54;
    private static final Vec3 CENTRE = new Vec3(0, 10, -120);
    private static final List<Cloud.Puff> HEAP = List.of(
            new Cloud.Puff(new Vec3(-16, 0, 4), 14),
            new Cloud.Puff(new Vec3(4, -2, -10), 18),
            new Cloud.Puff(new Vec3(10, 8, 6), 12),
            new Cloud.Puff(new Vec3(24, -3, 0), 9));

    private final Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static Cloud cloud(List<Cloud.Puff> puffs, double perMetre, double albedo, CloudTechnique technique) {
        return new Cloud(
                "heap",
                new Cloud.Extent.Volume(CENTRE, new Vec3(80, 60, 60)),
                technique,
                new Cloud.Density.Puffs(puffs, null),
                perMetre,
                albedo,
                0.85);
    }

    private static Level under(double sky, double sun, Cloud cloud) {
        return new TestLevel()
                .sky(new Sky.Constant(TestLevel.grey(sky)))
                .sun(new Vec3(0.5, 0.6, 0.6), sun)
                .cloud(cloud)
                .level();
    }

    private float[] drawn(Level level, Quality quality, View view) {
        return drawn(level, quality, List.of(view)).get(0);
    }

    private List<float[]> drawn(Level level, Quality quality, List<View> views) {
        var settings = RenderSettings.of(Output.HDR, quality);
        List<float[]> pictures = new ArrayList<>();
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            for (View view : views) {
                renderer.forget();
                renderer.draw(view, offscreen.picture);
                offscreen.gl.requireNoError("frame");
                pictures.add(renderer.readRadiance());
            }
        }
        return pictures;
    }

    private View view() {
        return offscreen.view(Vec3.ZERO, CENTRE);
    }

    private Ray ray(View view, int pixel) {
        return Ray.of(view.eye(), offscreen.ray(view, pixel));
    }

    /** Balls that scatter nothing show how much of the white sky passes. */
    @ParameterizedTest
    @CsvSource({
        "PARTICLES, 0.002, 0, 10, -30",
        "PARTICLES, 0.002, 0, 0, 0",
        "PARTICLES, 0.002, 60, 30, -160",
        "PARTICLES, 0.002, 0, 90, -121",
        "BILLBOARD, 0.01, 0, 0, 0",
        "BILLBOARD, 0.01, 0, 130, -121"
    })
    void whatPassesIsTheClosedForm(CloudTechnique technique, double most, double x, double y, double z) {
        Level level = under(1, 0, cloud(HEAP, 0.06, 0, technique));
        View view = offscreen.view(new Vec3(x, y, z), CENTRE);
        float[] seen = drawn(level, Quality.ULTRA.with("samples", 1), view);
        var field = new PuffsField(HEAP, CENTRE, 0.06);
        double squares = 0;
        int count = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            double depth =
                    field.closedDepth(ray(view, i), 0, Double.POSITIVE_INFINITY).orElseThrow();
            if (depth > 0.01) {
                double error = seen[3 * i] - Math.exp(-depth);
                squares += error * error;
                count++;
            }
        }
        assertTrue(count > 100, count + " pixels");
        assertEquals(0, Math.sqrt(squares / count), most);
    }

    @ParameterizedTest
    @CsvSource({
        "PARTICLES, 0, 0.05",
        "PARTICLES, 1, 0.5",
        "PARTICLES, 2, 500",
        "PARTICLES, 3, 0.5",
        "BILLBOARD, 0, 0.05",
        "BILLBOARD, 1, 0.5",
        "BILLBOARD, 2, 500",
        "BILLBOARD, 3, 0.5"
    })
    void aWhiteFurnaceIsWhite(CloudTechnique technique, int preset, double perMetre) {
        Quality quality = List.of(Quality.LOW, Quality.MEDIUM, Quality.HIGH, Quality.ULTRA)
                .get(preset);
        Level level = under(1, 0, cloud(HEAP, perMetre, 1, technique));
        Vec3 target = new Vec3(0, 12, -150);
        List<View> views = List.of(offscreen.view(Vec3.ZERO, target), offscreen.view(CENTRE, target));
        for (float[] picture : drawn(level, quality, views)) {
            for (float value : picture) {
                assertEquals(1, value, 1 / 255.0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"PARTICLES", "BILLBOARD"})
    void withoutDepthNothingIsDrawn(CloudTechnique technique) {
        Level without = new TestLevel()
                .sky(new Sky.Constant(TestLevel.grey(0.7)))
                .sun(new Vec3(0.5, 0.6, 0.6), 3)
                .level();
        Level with = under(0.7, 3, cloud(HEAP, 0, 1, technique));
        assertArrayEquals(drawn(without, Quality.HIGH, view()), drawn(with, Quality.HIGH, view()));
    }

    /** The volume is within 5 % of the reference on the mean. */
    @ParameterizedTest
    @CsvSource({
        "PARTICLES, 0.05, 0.01",
        "PARTICLES, 0.05, 0.06",
        "PARTICLES, 0.06, 0.4",
        "BILLBOARD, 0.1, 0.01",
        "BILLBOARD, 0.1, 0.06",
        "BILLBOARD, 0.1, 0.4"
    })
    void theCloudIsAsBrightAsTheVolume(CloudTechnique technique, double most, double perMetre) {
        Level balls = under(0.3, 4, cloud(HEAP, perMetre, 1, technique));
        Level volume = under(0.3, 4, cloud(HEAP, perMetre, 1, CloudTechnique.VOLUME));
        List<View> views = List.of(Vec3.ZERO, new Vec3(-80, 50, -200), new Vec3(100, -20, -160)).stream()
                .map(eye -> offscreen.view(eye, CENTRE))
                .toList();
        List<float[]> marched = drawn(volume, Quality.ULTRA.with("samples", 1), views);
        List<float[]> blended = drawn(balls, Quality.ULTRA.with("samples", 1), views);
        var field = new PuffsField(HEAP, CENTRE, perMetre);
        for (int i = 0; i < views.size(); i++) {
            View view = views.get(i);
            double ratio = mean(blended.get(i), field, view) / mean(marched.get(i), field, view);
            assertEquals(1, ratio, most, "from " + view.eye());
        }
    }

    private double mean(float[] values, PuffsField field, View view) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            if (field.closedDepth(ray(view, i), 0, Double.POSITIVE_INFINITY).orElseThrow() > 0.01) {
                sum += values[3 * i];
                count++;
            }
        }
        return sum / count;
    }

    /** Two balls of half the density in the place of each one. */
    @Test
    void splittingBallsChangesNothing() {
        List<Cloud.Puff> twice = new ArrayList<>(HEAP);
        twice.addAll(HEAP);
        float[] one = drawn(
                under(0.3, 4, cloud(HEAP, 0.06, 1, CloudTechnique.PARTICLES)),
                Quality.ULTRA.with("samples", 1),
                view());
        float[] two = drawn(
                under(0.3, 4, cloud(twice, 0.03, 1, CloudTechnique.PARTICLES)),
                Quality.ULTRA.with("samples", 1),
                view());
        double sumOne = 0;
        double sumTwo = 0;
        for (int i = 0; i < one.length; i++) {
            assertEquals(one[i], two[i], 0.03 * one[i]);
            sumOne += one[i];
            sumTwo += two[i];
        }
        assertEquals(1, sumTwo / sumOne, 0.01);
    }

    /**
     * A way through the cloud in steps of 1 m: no undefined value, and no ball appears or vanishes at once. A billboard gives way
     * to its ball when the eye enters that, but keeps the light of the picture.
     */
    @ParameterizedTest
    @CsvSource({"PARTICLES, 0.02", "BILLBOARD, 0.05"})
    void theEyePassesThroughBalls(CloudTechnique technique, double most) {
        Level level = under(0.3, 4, cloud(HEAP, 0.06, 1, technique));
        var settings = RenderSettings.of(Output.HDR, Quality.HIGH);
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            float[] before = null;
            for (double z = -70; z > -170; z -= 1) {
                Vec3 eye = new Vec3(2, 9, z);
                renderer.forget();
                renderer.draw(offscreen.view(eye, eye.plus(new Vec3(0.3, 0.05, -1))), offscreen.picture);
                float[] now = renderer.readRadiance();
                double sum = 0;
                for (int i = 0; i < now.length; i++) {
                    assertTrue(Float.isFinite(now[i]) && now[i] >= 0, "at " + z);
                    sum += before == null ? 0 : Math.abs(now[i] - before[i]);
                }
                assertEquals(0, sum / now.length, most, "mean step at " + z);
                before = now;
            }
        }
    }

    /** Light that is interpolated over two triangles depends on their diagonal unless it is linear. */
    @ParameterizedTest
    @EnumSource(
            value = CloudTechnique.class,
            names = {"PARTICLES", "BILLBOARD"})
    void aMirroredCloudIsAMirroredPicture(CloudTechnique technique) {
        View ahead = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -120));
        float[] one = drawn(lit(1, technique), Quality.ULTRA.with("samples", 1), ahead);
        float[] other = drawn(lit(-1, technique), Quality.ULTRA.with("samples", 1), ahead);
        double brightest = 0;
        double farthest = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            int mirrored = i / WIDTH * WIDTH + WIDTH - 1 - i % WIDTH;
            brightest = Math.max(brightest, one[3 * i]);
            farthest = Math.max(farthest, Math.abs(one[3 * i] - other[3 * mirrored]));
        }
        assertEquals(0, farthest / brightest, 0.003);
    }

    /** @param side 1 or −1; the level of one is the mirror image of that of the other */
    private static Level lit(int side, CloudTechnique technique) {
        List<Cloud.Puff> puffs = HEAP.stream()
                .map(puff -> new Cloud.Puff(
                        new Vec3(
                                side * puff.centre().x(),
                                puff.centre().y(),
                                puff.centre().z()),
                        puff.radiusMetres()))
                .toList();
        return new TestLevel()
                .sky(new Sky.Constant(TestLevel.grey(0.3)))
                .sun(new Vec3(side * 0.8, 0.35, 0.45), 4)
                .cloud(cloud(puffs, 0.4, 1, technique))
                .level();
    }

    @Test
    void farFromTheOriginItLooksTheSame() {
        Vec3 far = new Vec3(1 << 20, 0, -(1 << 20));
        float[] here = drawn(
                under(0.3, 4, cloud(HEAP, 0.06, 1, CloudTechnique.PARTICLES)),
                Quality.ULTRA.with("samples", 1),
                view());
        Cloud moved = new Cloud(
                "heap",
                new Cloud.Extent.Volume(CENTRE.plus(far), new Vec3(80, 60, 60)),
                CloudTechnique.PARTICLES,
                new Cloud.Density.Puffs(HEAP, null),
                0.06,
                1,
                0.85);
        float[] there =
                drawn(under(0.3, 4, moved), Quality.ULTRA.with("samples", 1), offscreen.view(far, CENTRE.plus(far)));
        for (int i = 0; i < here.length; i++) {
            assertEquals(here[i], there[i], 1 / 255.0);
        }
    }

    /** From 3,600 directions, straight above and below among them, and from the centre of a ball. */
    @ParameterizedTest
    @EnumSource(names = {"SCREEN", "VIEWER", "AXIAL"})
    void aBillboardHasNoSingularDirection(BillboardFacing facing) {
        List<Cloud.Puff> one = List.of(new Cloud.Puff(Vec3.ZERO, 20));
        Level level = under(0.3, 4, cloud(one, 0.1, 1, CloudTechnique.BILLBOARD));
        var quality = Quality.HIGH.with("billboardFacing", facing).with("cloudResolution", 1);
        try (var tiny = RenderTarget.picture(offscreen.gl, "tiny", PixelFormat.RGBA8, 3, 3);
                Renderer renderer = LevelRenderer.load(
                        offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR, quality))) {
            for (int n = 0; n < 3600; n++) {
                double y = n < 2 ? 1 - 2 * n : 1 - (n - 1.5) / 1799;
                double horizontal = Math.sqrt(1 - y * y);
                Vec3 away = new Vec3(horizontal * Math.cos(2.4 * n), y, horizontal * Math.sin(2.4 * n));
                renderer.forget();
                Vec3 eye = CENTRE.addScaled(n == 2 ? 0 : 90, away);
                renderer.draw(offscreen.view(eye, CENTRE.addScaled(1e-3, away)), tiny);
                float[] seen = renderer.readRadiance();
                float middle = seen[3 * (3 * 1 + 1)];
                boolean isEdgeOn = facing == BillboardFacing.AXIAL && Math.abs(y) > 0.8;
                assertTrue(middle > 0.302 || isEdgeOn && middle >= 0.29, facing + " from " + away + ": " + middle);
            }
        }
    }
}
