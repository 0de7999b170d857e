package nephele.lab.art;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.atmosphere.SunOverLimb;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.SkyboxSquare;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.ToneMapping;

/** The whole sky around an eye as six pictures, in linear radiance until they are encoded in 8 bits. */
public final class BakedSkybox {
    private static final List<SkyboxSquare> SQUARES = SkyboxSquare.of(SkyboxLayout.FACES);

    public static final int FACES = SQUARES.size();

    /** Places along a side of a pixel at which the sun's disc is evaluated. */
    private static final int DISC_STEPS = 8;

    private final int side;
    private final List<float[]> faces;
    private final double sunShare;
    private final EightBitLoss loss;
    private int discPixels;

    /**
     * @param side of a picture, pixels
     * @param faces linear radiance, RGB, the bottom row first; kept, not copied
     * @param sunShare the share of the light of sun or moon that clouds let pass on its way to the eye
     */
    public BakedSkybox(int side, List<float[]> faces, double sunShare) {
        this.side = side;
        this.faces = List.copyOf(faces);
        this.sunShare = sunShare;
        loss = tallied();
    }

    /** Returns the file of a picture, without the end that says its format. */
    public static String file(String name, int face) {
        return name + "-" + SQUARES.get(face).name();
    }

    /** Adds the sun's disc. */
    void add(SunDisc disc) {
        double reach = Math.cos(SunOverLimb.RADIUS_RADIANS + Math.sqrt(2) / side);
        for (int face = 0; face < FACES; face++) {
            for (int pixel = 0; pixel < side * side; pixel++) {
                Vec3 middle = direction(face, pixel, 0.5, 0.5);
                if (middle.dot(disc.towardsSun()) > reach) {
                    add(disc, face, pixel);
                }
            }
        }
    }

    private void add(SunDisc disc, int face, int pixel) {
        Vec3 sum = Vec3.ZERO;
        for (int i = 0; i < DISC_STEPS * DISC_STEPS; i++) {
            Vec3 direction =
                    direction(face, pixel, (i % DISC_STEPS + 0.5) / DISC_STEPS, (i / DISC_STEPS + 0.5) / DISC_STEPS);
            sum = sum.addScaled(1.0 / (DISC_STEPS * DISC_STEPS), disc.towards(direction));
        }
        discPixels += sum.equals(Vec3.ZERO) ? 0 : 1;
        float[] rgb = faces.get(face);
        rgb[3 * pixel] += (float) sum.x();
        rgb[3 * pixel + 1] += (float) sum.y();
        rgb[3 * pixel + 2] += (float) sum.z();
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

    private static int code(double linear) {
        return (int) Math.round(255 * ToneMapping.encodeSrgb(Math.max(0, Math.min(1, linear))));
    }

    /** Returns what 8 bits lose, the sun's disc apart. */
    public EightBitLoss loss() {
        return loss;
    }

    /** Returns how many pixels the sun's disc is in; 8 bits clip them all. */
    public int discPixels() {
        return discPixels;
    }

    private EightBitLoss tallied() {
        EightBitLoss.Tally tally = new EightBitLoss.Tally();
        for (int face = 0; face < FACES; face++) {
            for (int pixel = 0; pixel < side * side; pixel++) {
                double fromMiddle = SQUARES.get(face).direction(0, 0).dot(direction(face, pixel, 0.5, 0.5));
                // A pixel's solid angle falls with the third power of this cosine.
                tally.add(faces.get(face), pixel, fromMiddle * fromMiddle * fromMiddle);
            }
        }
        return tally.loss();
    }

    /** Returns the share of the light of sun or moon that clouds let pass on its way to the eye. */
    public double sunShare() {
        return sunShare;
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
                : new Sun(sun.directionTowardsSun(), sun.irradiance().scaled(sunShare), sun.castsShadow());
        Environment environment = old.withoutClouds().with(dimmed).with(new Sky.Skybox(SkyboxLayout.FACES, files));
        return lit.with(environment, lit.lights());
    }
}
