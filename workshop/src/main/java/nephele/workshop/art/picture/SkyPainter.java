package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.appearance.SkyboxSquare;
import nephele.engine.math.Vec3;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Pixels;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.TileNoise;
import org.joml.Vector3d;

/**
 * Painter of a sky on a mild forenoon over a bay: haze at the horizon, fair-weather clouds, hills on three sides and
 * the sea.
 */
public final class SkyPainter {
    private static final int LAYOUT_PIXELS = 128;
    private static final List<SkyboxLayout> LAYOUTS =
            List.of(SkyboxLayout.OPENGL, SkyboxLayout.QUAKE2, SkyboxLayout.TERRAGEN);

    static final int SIDE_PIXELS = 512;
    /**
     * The direction to the sun in this sky, not of unit length; a level with this sky gives its sun the same direction.
     */
    static final Vec3 SUN_DIRECTION = new Vec3(0.62, 0.66, 0.42);

    public static final String CROSS_FILE = "textures/sky-bay-cross.png";
    private static final List<String> FACES = List.of("px", "nx", "py", "ny", "pz", "nz");

    private static final PaintColour ZENITH = PaintColour.of(0x3468B4);
    private static final PaintColour UPPER = PaintColour.of(0x629DDB);
    private static final PaintColour LOWER = PaintColour.of(0xA0C8E8);
    private static final PaintColour HAZE = PaintColour.of(0xE4E7E2);
    private static final PaintColour SUNLIT = PaintColour.of(0xFFF3DC);
    private static final PaintColour BRIGHT = PaintColour.of(0xFFFFFF);
    private static final PaintColour CLOUD_SHADE = PaintColour.of(0xB4C2D3);
    private static final PaintColour SEA_NEAR = PaintColour.of(0x2C5F7C);
    /** Dry sunlit land below the eye, away from the bay, which lights the scene from below like a bright floor. */
    private static final PaintColour SAND = PaintColour.of(0xD8C7A6);

    /** Above the sine of any crest's altitude: its noise is below 2. */
    private static final double HIGHEST_CREST = 0.41;

    private static final PaintColour SEA_FAR = PaintColour.of(0x9FBCCB);
    private static final PaintColour[] HILLS = {
        PaintColour.of(0xA7B9C4), PaintColour.of(0x869F9F), PaintColour.of(0x66806C)
    };

    private final Vector3d sunDirection = SUN_DIRECTION.toVector().normalize();

    public static List<String> files() {
        return FACES.stream().map(face -> "textures/sky-bay-" + face + ".png").toList();
    }

    /** @param face index in the order +x, −x, +y, −y, +z, −z */
    public BufferedImage face(int face) {
        return Pixels.picture(SIDE_PIXELS, SIDE_PIXELS, (column, row) -> rgb(face, column, row, SIDE_PIXELS));
    }

    /** Paints the whole sky as a cross of four columns and three rows; the middle row is −x −z +x +z. */
    public BufferedImage cross() {
        int side = SIDE_PIXELS / 2;
        int[][] faces = {{-1, 2, -1, -1}, {1, 5, 0, 4}, {-1, 3, -1, -1}};
        return Pixels.picture(4 * side, 3 * side, (column, row) -> {
            int face = faces[row / side][column / side];
            return face < 0 ? 0 : rgb(face, column % side, row % side, side);
        });
    }

    /** Returns one square of any layout. */
    BufferedImage square(SkyboxSquare square, int side) {
        return Pixels.picture(side, side, (column, row) -> {
            double right = 2 * (column + 0.5) / side - 1;
            double down = 2 * (row + 0.5) / side - 1;
            return colour(square.direction(right, down).toVector().normalize()).rgb();
        });
    }

    private int rgb(int face, int column, int row, int side) {
        double right = 2 * (column + 0.5) / side - 1;
        double up = 1 - 2 * (row + 0.5) / side;
        return colour(direction(face, right, up).normalize()).rgb();
    }

    /**
     * Returns the direction of a face's point as seen from the middle; +y has its bottom edge and −y its top edge at
     * −z.
     */
    private static Vector3d direction(int face, double right, double up) {
        return switch (face) {
            case 0 -> new Vector3d(1, up, right);
            case 1 -> new Vector3d(-1, up, -right);
            case 2 -> new Vector3d(right, 1, up);
            case 3 -> new Vector3d(right, -1, -up);
            case 4 -> new Vector3d(-right, up, 1);
            default -> new Vector3d(right, up, -1);
        };
    }

    private PaintColour colour(Vector3d direction) {
        double hazeline = 1 - Shapes.ramp(0, 0.12, Math.abs(direction.y));
        PaintColour colour = direction.y > 0 ? clouds(direction, air(direction)) : sea(direction);
        if (direction.y > -0.006 && direction.y < HIGHEST_CREST) {
            colour = hills(direction, colour);
        }
        return colour.mix(HAZE, 0.12 * hazeline);
    }

    private PaintColour hills(Vector3d direction, PaintColour behind) {
        double turn = turn(direction);
        PaintColour colour = behind;
        for (int layer = 0; layer < HILLS.length; layer++) {
            double crest = crest(turn, layer);
            double inside = 1 - Shapes.ramp(crest - 0.0015, crest + 0.0015, direction.y);
            if (crest <= 0 || inside == 0) {
                continue;
            }
            double onLand = inside * Shapes.ramp(-0.006, -0.003, direction.y);
            double fold = relief(turn, direction.y, layer);
            PaintColour slope = HILLS[layer].times(1 + 0.10 * fold).mix(HAZE, 0.35 * Shapes.ramp(0.03, 0, direction.y));
            colour = colour.mix(slope, onLand);
        }
        return colour;
    }

    private PaintColour air(Vector3d direction) {
        double up = Math.max(0, direction.y);
        PaintColour air = HAZE.mix(LOWER, Shapes.ramp(-0.06, 0.22, up));
        air = air.mix(UPPER, Shapes.ramp(0.08, 0.55, up)).mix(ZENITH, 0.9 * Shapes.ramp(0.35, 1, up));
        double towardsSun = Math.max(0, direction.dot(sunDirection));
        double glow = 0.28 * power(towardsSun, 3) + 0.35 * power(towardsSun, 6) + 0.6 * power(towardsSun, 10);
        return air.mix(SUNLIT, Math.min(1, 0.75 * glow));
    }

    /** Returns {@code base} squared {@code doublings} times. */
    private static double power(double base, int doublings) {
        double result = base;
        for (int i = 0; i < doublings; i++) {
            result *= result;
        }
        return result;
    }

    /** Paints fair-weather clouds on a flat layer, brighter on the side towards the sun. */
    private PaintColour clouds(Vector3d direction, PaintColour air) {
        double reach = 1 / (direction.y + 0.09);
        double x = direction.x * reach / 48 + 0.5;
        double z = direction.z * reach / 48 + 0.5;
        double density = density(x, z);
        if (density <= 0) {
            return air;
        }
        double step = 0.006;
        double sunward = density(x + step * sunDirection.x, z + step * sunDirection.z);
        double lit = Math.max(0, Math.min(1, 0.86 + 1.3 * (density - sunward) - 0.3 * density));
        PaintColour cloud = CLOUD_SHADE.mix(SUNLIT.mix(BRIGHT, 0.6), lit);
        double cover = Shapes.ramp(0, 0.55, density) * Shapes.ramp(0.02, 0.2, direction.y);
        return air.mix(cloud.mix(air, 0.3 * Shapes.ramp(0.3, 0.05, direction.y)), 0.92 * cover)
                .mix(BRIGHT, 0.6 * cover * power(Math.max(0, direction.dot(sunDirection)), 4));
    }

    private static double density(double x, double z) {
        TileNoise noise = new TileNoise(307);
        double field = noise.cloud(x, z, 33, 6) + 0.35 * new TileNoise(311).cloud(x, z, 11, 2);
        return Math.max(0, field - 0.03) * 1.5;
    }

    private PaintColour sea(Vector3d direction) {
        double down = Math.min(1, -direction.y);
        double reach = 1 / (down + 0.03);
        double swell = new TileNoise(313)
                .stretched(direction.x * reach / 128 + 0.5, direction.z * reach / 128 + 0.5, 256, 256, 3);
        PaintColour water =
                SEA_FAR.mix(SEA_NEAR, Shapes.ramp(0, 0.2, down)).times(1 + 0.05 * swell * Shapes.ramp(0, 0.1, down));
        double land = Shapes.ramp(0.1, 0.25, Math.abs(turn(direction) - 0.47)) * Shapes.ramp(0.004, 0.05, down);
        return water.mix(SAND, Math.max(land, Shapes.ramp(0.45, 0.8, down)));
    }

    /** Returns the sine of the altitude of a ridge; negative where there is only sea. */
    private static double crest(double turn, int layer) {
        TileNoise noise = new TileNoise(331 + 7 * layer);
        double ridge = 0.5 + 0.5 * noise.cloud(turn, 0.3, 6 + 4 * layer, 6);
        double bay = Shapes.ramp(0.04 + 0.05 * layer, 0.16 + 0.06 * layer, Math.abs(turn - 0.47));
        return bay * ridge * (0.27 - 0.075 * layer) - 0.004;
    }

    /** Returns the azimuth as a fraction of a turn, 0.5 at −z. */
    private static double turn(Vector3d direction) {
        return StrictMath.atan2(direction.x, -direction.z) / (2 * Math.PI) + 0.5;
    }

    private static double relief(double turn, double up, int layer) {
        return new TileNoise(349 + layer).cloud(turn, up * 0.6 + 0.5, 48, 4);
    }

    /** Returns the asset ids of a layout in its order, in the format that its programs write. */
    private static List<String> layoutFiles(SkyboxLayout layout) {
        return SkyboxSquare.of(layout).stream()
                .map(square -> layoutFile(layout, square.name()))
                .toList();
    }

    private static String layoutFile(SkyboxLayout layout, String name) {
        return switch (layout) {
            case QUAKE2 -> "textures/sky-bay-quake2/bay_" + name + ".tga";
            case TERRAGEN -> "textures/sky-bay-terragen/" + name + ".bmp";
            case OPENGL, FACES, CROSS -> "textures/sky-bay-opengl/" + name + ".png";
        };
    }

    /** Returns the painted pictures by asset id. */
    public static Map<String, BufferedImage> layouts() {
        Map<String, BufferedImage> pictures = new LinkedHashMap<>();
        SkyPainter painter = new SkyPainter();
        for (SkyboxLayout layout : LAYOUTS) {
            List<String> files = layoutFiles(layout);
            for (int i = 0; i < files.size(); i++) {
                SkyboxSquare square = SkyboxSquare.of(layout).get(i);
                pictures.put(files.get(i), painter.square(square, LAYOUT_PIXELS));
            }
        }
        return pictures;
    }
}
