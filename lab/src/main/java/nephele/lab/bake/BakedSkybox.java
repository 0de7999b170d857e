package nephele.lab.bake;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.NightSky;
import nephele.engine.level.appearance.SkyboxSquare;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.reference.sky.SunDisc;
import nephele.engine.render.frame.ToneMapping;

/** The whole sky around an eye as six pictures, in linear radiance until they are encoded in 8 bits, without dither. */
public final class BakedSkybox {
    private static final List<SkyboxSquare> SQUARES = SkyboxSquare.of(SkyboxLayout.FACES);

    public static final int FACES = SQUARES.size();

    /** Least number of places along a side of a pixel at which a disc is evaluated; along its radius there are two. */
    private static final int DISC_STEPS = 8;

    /** Starlight that 8 bits do not show, as a fraction of white: a thirtieth of the first code. */
    private static final double FAINT = 1e-5;

    private final int side;
    private final List<float[]> faces;
    private final double sunFraction;
    private final double whiteRadiance;
    private final EightBitLoss loss;
    private int discPixels;

    /**
     * @param side of a picture, pixels
     * @param faces linear radiance, RGB, the bottom row first; kept, not copied
     * @param sunFraction the fraction of the light of sun or moon that clouds let pass on its way to the eye
     */
    public BakedSkybox(int side, List<float[]> faces, double sunFraction) {
        this.side = side;
        this.faces = List.copyOf(faces);
        this.sunFraction = sunFraction;
        whiteRadiance = white(faces);
        loss = tallied();
    }

    /**
     * Returns the radiance that white stands for: 1, or less under a dark sky, three stops above its brightest place,
     * which leaves room for moon and stars.
     */
    private static double white(List<float[]> faces) {
        float brightest = 0;
        for (float[] rgb : faces) {
            for (float value : rgb) {
                brightest = Math.max(brightest, value);
            }
        }
        return brightest > 0 ? Math.min(1, Math.scalb(1.0, Math.getExponent(brightest) + 4)) : 1;
    }

    /** Returns the file of a picture, without the end that says its format. */
    public static String file(String name, int face) {
        return name + "-" + SQUARES.get(face).name();
    }

    /**
     * Adds the sun's disc.
     *
     * @param eyeHeight y of the eye
     * @param fraction of its light that passes the clouds
     */
    void add(SunDisc sun, double eyeHeight, double fraction) {
        discPixels = add(direction -> sun.towards(direction, eyeHeight), sun.middle(), sun.radiusRadians(), fraction);
    }

    /**
     * Adds moon and stars.
     *
     * @param fraction of the light from a unit direction that passes the clouds
     */
    void add(NightSky night, ToDoubleFunction<Vec3> fraction) {
        Vec3 moon = night.towardsMoon();
        add(night::moon, moon, NightSky.MOON_RADIUS_RADIANS, fraction.applyAsDouble(moon));
        IntStream.range(0, FACES).parallel().forEach(face -> {
            for (int pixel = 0; pixel < side * side; pixel++) {
                double radians = direction(face, pixel, 1, 0.5)
                        .minus(direction(face, pixel, 0, 0.5))
                        .length();
                Vec3 towards = direction(face, pixel, 0.5, 0.5);
                Vec3 stars = night.stars(towards, radians);
                if (stars.y() > FAINT * whiteRadiance) {
                    add(face, pixel, stars.scaled(fraction.applyAsDouble(towards)));
                }
            }
        });
    }

    /** Adds a disc and returns the number of pixels that it is in. */
    private int add(UnaryOperator<Vec3> disc, Vec3 towards, double radians, double fraction) {
        double reach = Math.cos(radians + Math.sqrt(2) / side);
        int steps = (int) Math.max(DISC_STEPS, Math.ceil(4 / (side * radians)));
        int pixels = 0;
        for (int face = 0; face < FACES; face++) {
            for (int pixel = 0; pixel < side * side; pixel++) {
                if (direction(face, pixel, 0.5, 0.5).dot(towards) > reach) {
                    Vec3 light = inPixel(disc, steps, face, pixel);
                    add(face, pixel, light.scaled(fraction));
                    pixels += light.equals(Vec3.ZERO) ? 0 : 1;
                }
            }
        }
        return pixels;
    }

    private Vec3 inPixel(UnaryOperator<Vec3> disc, int steps, int face, int pixel) {
        Vec3 sum = Vec3.ZERO;
        for (int i = 0; i < steps * steps; i++) {
            Vec3 direction = direction(face, pixel, (i % steps + 0.5) / steps, (i / steps + 0.5) / steps);
            sum = sum.addScaled(1.0 / (steps * steps), disc.apply(direction));
        }
        return sum;
    }

    private void add(int face, int pixel, Vec3 light) {
        float[] rgb = faces.get(face);
        rgb[3 * pixel] += (float) light.x();
        rgb[3 * pixel + 1] += (float) light.y();
        rgb[3 * pixel + 2] += (float) light.z();
    }

    /** Returns the unit direction of a place in a pixel. */
    private Vec3 direction(int face, int pixel, double right, double up) {
        double s = 2 * (pixel % side + right) / side - 1;
        double t = 1 - 2 * (pixel / side + up) / side;
        return Directions.unit(SQUARES.get(face).direction(s, t));
    }

    /** Returns a face, sRGB. */
    public BufferedImage picture(int face) {
        BufferedImage picture = new BufferedImage(side, side, BufferedImage.TYPE_INT_RGB);
        float[] rgb = faces.get(face);
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++) {
                int at = 3 * ((side - 1 - y) * side + x);
                picture.setRGB(x, y, code(rgb[at]) << 16 | code(rgb[at + 1]) << 8 | code(rgb[at + 2]));
            }
        }
        return picture;
    }

    private int code(double radiance) {
        return (int) Math.round(255 * ToneMapping.encodeSrgb(Math.max(0, Math.min(1, radiance / whiteRadiance))));
    }

    /** Returns what 8 bits lose, sun's disc, moon and stars apart. */
    public EightBitLoss loss() {
        return loss;
    }

    /** Returns how many pixels the sun's disc is in; 8 bits clip them all. */
    public int discPixels() {
        return discPixels;
    }

    private EightBitLoss tallied() {
        int clipped = 0;
        int dark = 0;
        double brightest = 0;
        double light = 0;
        double above = 0;
        for (int face = 0; face < FACES; face++) {
            float[] rgb = faces.get(face);
            for (int pixel = 0; pixel < side * side; pixel++) {
                double fromMiddle = SQUARES.get(face).direction(0, 0).dot(direction(face, pixel, 0.5, 0.5));
                // A pixel's solid angle falls with the third power of this cosine.
                double steradians = fromMiddle * fromMiddle * fromMiddle;
                double most = 0;
                for (int at = 3 * pixel; at < 3 * pixel + 3; at++) {
                    most = Math.max(most, rgb[at]);
                    light += steradians * rgb[at];
                    above += steradians * Math.max(0, rgb[at] - whiteRadiance);
                }
                clipped += most > whiteRadiance ? 1 : 0;
                dark += most < EightBitLoss.FIRST_CODE * whiteRadiance ? 1 : 0;
                brightest = Math.max(brightest, most);
            }
        }
        double lost = light > 0 ? above / light : 0;
        return new EightBitLoss(whiteRadiance, FACES * side * side, clipped, dark, brightest, lost);
    }

    /** Returns the fraction of the light of sun or moon that clouds let pass on its way to the eye. */
    public double sunFraction() {
        return sunFraction;
    }

    /**
     * Returns the level with the pictures as its sky, which hold its clouds, and the sun as air and clouds have left it.
     *
     * @param lit the level with the sun of its hour
     * @param name of the pictures
     */
    public Level usedBy(Level lit, String name) {
        Environment old = lit.environment();
        List<String> files = IntStream.range(0, FACES)
                .mapToObj(face -> file(name, face) + ".png")
                .toList();
        Sun sun = Daylight.onGround(old);
        Sun dimmed = sun == null
                ? null
                : new Sun(sun.directionTowardsSun(), sun.irradiance().scaled(sunFraction), sun.castsShadow());
        Environment environment =
                old.withoutClouds().with(dimmed).with(new Sky.Skybox(SkyboxLayout.FACES, files, whiteRadiance));
        return lit.with(environment, lit.lights());
    }
}
