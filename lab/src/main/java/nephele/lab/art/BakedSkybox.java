package nephele.lab.art;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.level.appearance.SkyboxSquare;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.ToneMapping;
import org.joml.Vector3d;

/** The whole sky around an eye as six pictures, in linear radiance until they are encoded in 8 bits. */
public final class BakedSkybox {
    /** The ends of the files' names, in the order of the files. */
    public static final List<String> NAMES =
            SkyboxSquare.of(SkyboxLayout.FACES).stream().map(SkyboxSquare::name).toList();

    /** The radiance whose code is 1. */
    private static final double FIRST_CODE = 1 / (255 * 12.92);

    private final SkyRadiance sky;
    private final double eyeHeight;
    private final int side;
    private final int samples;
    private final float[] rgb;

    /** @param samples a pixel; the next square number is taken */
    public BakedSkybox(SkyRadiance sky, Vec3 eye, int side, int samples) {
        this.sky = sky;
        eyeHeight = eye.y();
        this.side = side;
        this.samples = (int) Math.ceil(Math.sqrt(samples));
        rgb = new float[3 * NAMES.size() * side * side];
    }

    /** @param progress receives the completed fraction, 0–1, from any thread */
    public void trace(DoubleConsumer progress) {
        int rows = NAMES.size() * side;
        AtomicInteger done = new AtomicInteger();
        IntStream.range(0, rows).parallel().forEach(row -> {
            for (int column = 0; column < side; column++) {
                trace(SkyboxSquare.of(SkyboxLayout.FACES).get(row / side), column, row);
            }
            progress.accept((double) done.incrementAndGet() / rows);
        });
    }

    private void trace(SkyboxSquare square, int column, int row) {
        Vector3d sum = new Vector3d();
        for (int i = 0; i < samples * samples; i++) {
            double s = 2 * (column + (i % samples + 0.5) / samples) / side - 1;
            double t = 2 * (row % side + (i / samples + 0.5) / samples) / side - 1;
            Vector3d d = new Vector3d(along(square, 0, s, t), along(square, 1, s, t), along(square, 2, s, t));
            d.normalize();
            sum.add(sky.from(eyeHeight, d.x, d.y, d.z));
        }
        sum.div(samples * samples);
        for (int c = 0; c < 3; c++) {
            rgb[3 * (row * side + column) + c] = (float) sum.get(c);
        }
    }

    private static double along(SkyboxSquare square, int axis, double s, double t) {
        return square.outward().component(axis)
                + s * square.right().component(axis)
                + t * square.down().component(axis);
    }

    /** Returns a face, sRGB. */
    public BufferedImage picture(int face) {
        BufferedImage picture = new BufferedImage(side, side, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++) {
                int at = 3 * ((face * side + y) * side + x);
                picture.setRGB(x, y, code(rgb[at]) << 16 | code(rgb[at + 1]) << 8 | code(rgb[at + 2]));
            }
        }
        return picture;
    }

    private static int code(double linear) {
        return (int) Math.round(255 * ToneMapping.encodeSrgb(Math.max(0, Math.min(1, linear))));
    }

    /** Returns the share of pixels with a channel above 1. */
    public double clippedShare() {
        return share(pixel -> brightest(pixel) > 1);
    }

    /** Returns the share of pixels of which no channel reaches the first code. */
    public double darkShare() {
        return share(pixel -> brightest(pixel) < FIRST_CODE);
    }

    private double share(java.util.function.IntPredicate condition) {
        int pixels = rgb.length / 3;
        return IntStream.range(0, pixels).filter(condition).count() / (double) pixels;
    }

    private float brightest(int pixel) {
        return Math.max(rgb[3 * pixel], Math.max(rgb[3 * pixel + 1], rgb[3 * pixel + 2]));
    }

    /** Returns the greatest radiance of a channel. */
    public double brightest() {
        return IntStream.range(0, rgb.length / 3)
                .mapToDouble(this::brightest)
                .max()
                .orElse(0);
    }

    /**
     * Returns the level with the pictures as its sky, and the sun as the air has left it.
     *
     * @param lit the level with the sun of its hour
     * @param name of the pictures
     */
    public Level usedBy(Level lit, String name) {
        Environment old = lit.environment();
        List<String> files =
                NAMES.stream().map(end -> name + "-" + end + ".png").toList();
        Environment environment = old.with(Daylight.onGround(old)).with(new Sky.Skybox(SkyboxLayout.FACES, files));
        return lit.with(environment, lit.lights());
    }
}
